#include "common/require.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace common {

void refuse(const char* name, const char* wanted, double got) {
  throw std::invalid_argument(std::string(name) + ": want " + wanted + ", got " +
                              std::to_string(got));
}

void refuse_entry(const char* name) {
  throw std::invalid_argument(std::string(name) + ": an entry is not finite");
}

void require_unit(const Vec3& value, const char* name) {
  if (!(std::abs(value.norm() - 1.0) <= 1e-9)) refuse(name, "length one", value.norm());
}

}  // namespace common
