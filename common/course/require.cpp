#include "common/course/require.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace common {
namespace {

/// The shortest decimal that reads back as the same double.
std::string shortest(double value) {
  char digits[32];
  const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), value);
  return {digits, end};
}

}  // namespace

void refuse(const char* name, const char* wanted, double got) {
  throw std::invalid_argument(std::string(name) + ": must be " + wanted + ", not " + shortest(got));
}

void refuse_entry(const char* name) {
  throw std::invalid_argument(std::string(name) + ": an entry is not finite");
}

void require_unit(const Vec3& value, const char* name) {
  if (!(std::abs(value.norm() - 1.0) <= 1e-9)) refuse(name, "of length one", value.norm());
}

}  // namespace common
