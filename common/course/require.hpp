#pragma once

#include <cmath>
#include <stdexcept>

#include "common/types.hpp"

/// Checks of arguments. Each throws std::invalid_argument with a text that names the argument and
/// what is wrong with it. No check accepts NaN.
namespace common {

/// Throws. The text contains the number with all its digits. It is apart from the checks, so that
/// they cost next to nothing if all is well.
[[noreturn]] void refuse(const char* name, const char* wanted, double got);
[[noreturn]] void refuse_entry(const char* name);

inline void require_finite(double value, const char* name) {
  if (!std::isfinite(value)) refuse(name, "a finite number", value);
}

inline void require_finite(const Vec3& value, const char* name) {
  if (!(std::isfinite(value.x()) && std::isfinite(value.y()) && std::isfinite(value.z()))) {
    refuse_entry(name);
  }
}

inline void require_positive(double value, const char* name) {
  if (!(value > 0.0 && std::isfinite(value))) refuse(name, "a finite number above zero", value);
}

inline void require_not_negative(double value, const char* name) {
  if (!(value >= 0.0 && std::isfinite(value))) refuse(name, "a finite number from zero up", value);
}

/// Requires a number from 0 to 1.
inline void require_fraction(double value, const char* name) {
  if (!(value >= 0.0 && value <= 1.0)) refuse(name, "a number from 0 to 1", value);
}

/// Requires length one, to 1e-9.
void require_unit(const Vec3& value, const char* name);

}  // namespace common
