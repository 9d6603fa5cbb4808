#pragma once

#include "render/scene.hpp"

namespace render {

/// Throws std::invalid_argument where a value of the scene is not finite or an index leads nowhere,
/// as in "box 3: position is not finite"; solids count from 0.
void check_scene(const Scene& scene);

/// Takes out of the scene what check_scene complains of, and returns the complaints.
std::vector<std::string> leave_out_broken(Scene& scene);

}  // namespace render
