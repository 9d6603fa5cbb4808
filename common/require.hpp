#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "common/types.hpp"

/// Checks of what a caller hands over. Each throws std::invalid_argument, whose text names the
/// argument and what is wrong with it, and lets NaN pass nowhere.
namespace common {

inline void require_finite(double value, const char* name) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument(std::string(name) + ": want a finite number, got " +
                                std::to_string(value));
  }
}

inline void require_finite(const Vec3& value, const char* name) {
  if (!value.allFinite()) {
    throw std::invalid_argument(std::string(name) + ": an entry is not finite");
  }
}

inline void require_positive(double value, const char* name) {
  if (!(value > 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(std::string(name) + ": want a finite number above zero, got " +
                                std::to_string(value));
  }
}

inline void require_not_negative(double value, const char* name) {
  if (!(value >= 0.0 && std::isfinite(value))) {
    throw std::invalid_argument(std::string(name) + ": want a finite number from zero up, got " +
                                std::to_string(value));
  }
}

/// Of length one to 1e-9.
inline void require_unit(const Vec3& value, const char* name) {
  if (!(std::abs(value.norm() - 1.0) <= 1e-9)) {
    throw std::invalid_argument(std::string(name) + ": want length one, got " +
                                std::to_string(value.norm()));
  }
}

}  // namespace common
