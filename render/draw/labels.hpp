#pragma once

#include "render/draw/view.hpp"
#include "render/files/image.hpp"
#include "render/scene.hpp"

namespace render {

/// Writes a scene's labels beside their points, each within the picture and, where there is room,
/// clear of arrows and of labels before it. What lies behind the eye or outside has none.
void draw_labels(Image& image, const View& view, const Scene& scene);

}  // namespace render
