#pragma once

#include <string>

namespace render {

/// GLSL sources. Positions are about the view's origin [m], colours linear light.
namespace shaders {

std::string solid_vertex();            ///< instances of shapes
std::string solid_fragment();          ///< lit, with soft shadows by filtering one depth map
std::string solid_sampled_fragment();  ///< lit by one sample of key light and sky
std::string arrow_fragment();          ///< nearly unlit
std::string depth_vertex();            ///< instances, as a light sees them
std::string depth_fragment();
std::string ground_vertex();
std::string ground_fragment();
std::string ground_sampled_fragment();
std::string stroke_vertex();  ///< what already lies in the picture
std::string stroke_fragment();

}  // namespace shaders
}  // namespace render
