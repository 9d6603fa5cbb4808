#pragma once

#include "render/draw/camera.hpp"
#include "render/scene.hpp"

namespace tests {

/// A scene with every kind of solid and of decoration, on the ground.
render::Scene gallery_scene();

/// Its camera, for a picture of that width over height.
render::Camera gallery_camera(double aspect);

/// A heap of boxes, rows x rows x layers, turned each in its own way.
render::Scene heap_of_boxes(int rows, int layers);

}  // namespace tests
