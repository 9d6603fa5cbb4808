#pragma once

#include "render/scene.hpp"

namespace render {

/// Throws std::invalid_argument where a value of the scene is not finite or an index leads nowhere,
/// as in "box 3: position is not finite"; solids count from 0.
void check_scene(const Scene& scene);

}  // namespace render
