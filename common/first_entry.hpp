#pragma once

#include <optional>

#include "common/double_double.hpp"

namespace common {

/// c₀ + c₁ t + c₂ t².
struct Quadratic {
  DoubleDouble c0, c1, c2;
};

/// c₀ + c₁ t + … + c₄ t⁴.
struct Quartic {
  DoubleDouble c0, c1, c2, c3, c4;
};

/// The first t in [0, dt] from which on the polynomial is zero or below and falls; none where there
/// is none. No root is lost: the quartic is cut at its turning points, and every sign is that of a
/// value with some 30 digits of its largest term.
std::optional<double> first_entry(const Quadratic& g, double dt);
std::optional<double> first_entry(const Quartic& g, double dt);

}  // namespace common
