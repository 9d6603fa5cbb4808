#pragma once

#include "render/scene.hpp"

namespace render {

/// How far a solid reaches from its position along each of the world's axes [m].
Vec3 reach_of(const Box& box);
Vec3 reach_of(const Sphere& sphere);
Vec3 reach_of(const Cylinder& cylinder);
Vec3 reach_of(const Capsule& capsule);

}  // namespace render
