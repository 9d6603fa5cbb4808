#pragma once

#include <optional>

#include "common/exact/double_double.hpp"

namespace common {

/// The polynomial c₀ + c₁ t + c₂ t².
struct Quadratic {
  DoubleDouble c0, c1, c2;
};

/// The polynomial c₀ + c₁ t + … + c₄ t⁴.
struct Quartic {
  DoubleDouble c0, c1, c2, c3, c4;
};

/// Returns the first t in [0, dt] from which on the polynomial is zero or below and falls, or none.
/// No root is lost, because the quartic is cut at its turning points, and every sign is taken from
/// a value with about 30 digits of its largest term.
std::optional<double> first_entry(const Quadratic& g, double dt);
std::optional<double> first_entry(const Quartic& g, double dt);

}  // namespace common
