#pragma once

namespace render {

/// An sRGB colour, each entry in [0, 1].
struct Colour {
  float red = 0.0F;
  float green = 0.0F;
  float blue = 0.0F;
};

/// Okabe and Ito's palette, which colour-blind readers can tell apart, and the colour of ink.
namespace palette {
inline constexpr Colour orange{0.902F, 0.624F, 0.0F};
inline constexpr Colour sky{0.337F, 0.706F, 0.914F};
inline constexpr Colour green{0.0F, 0.620F, 0.451F};
inline constexpr Colour yellow{0.941F, 0.894F, 0.259F};
inline constexpr Colour blue{0.0F, 0.447F, 0.698F};
inline constexpr Colour vermilion{0.835F, 0.369F, 0.0F};
inline constexpr Colour purple{0.800F, 0.475F, 0.655F};
inline constexpr Colour ink{0.157F, 0.173F, 0.204F};
inline constexpr Colour grey{0.55F, 0.57F, 0.60F};
}  // namespace palette

/// Returns the share of light, in [0, 1], of an sRGB value in [0, 1] (IEC 61966-2-1).
float linear_from_srgb(float value);

/// Returns the inverse of linear_from_srgb.
float srgb_from_linear(float value);

}  // namespace render
