#pragma once

#include <string>

namespace render::shaders {

/// Pieces of GLSL that several shaders share.
std::string version();         ///< the first line of each
std::string placing();         ///< where an instance puts a vertex and its normal
std::string receiver_plane();  ///< how depth changes across a lit plane
std::string soft_shadow();     ///< key_visibility() by filtering a depth map
std::string sampled_shadow();  ///< key_visibility() and sky_visibility() by one lookup each
std::string shading();         ///< the colour of a solid under these lights
std::string filtered_main();   ///< of a solid, with soft_shadow()
std::string sampled_main();    ///< of a solid, with sampled_shadow()
std::string ground_inputs();

}  // namespace render::shaders
