#include "common/elliptic/elliptic_integrals.hpp"

#include <cmath>

#include "common/elliptic/carlson.hpp"

namespace common {

double first_kind(const JacobiFunctions& at, double complementary_parameter) {
  if (complementary_parameter == 0.0) return std::asinh(at.sn / at.cn);
  return at.sn * carlson_rf(at.cn * at.cn, at.dn * at.dn, 1.0);
}

double third_kind(const JacobiFunctions& at, double r, double complementary_parameter) {
  const double u = first_kind(at, complementary_parameter);
  if (r > 1.0) {
    return (1.0 - 1.0 / r) * cosine_share(at, r, complementary_parameter) + u / r;
  }
  const double x = at.cn * at.cn;
  const double sine_squared = at.sn * at.sn;
  return u + (1.0 - r) / 3.0 * at.sn * sine_squared *
                 carlson_rj(x, at.dn * at.dn, 1.0, x + r * sine_squared);
}

double cosine_share(const JacobiFunctions& at, double r, double complementary_parameter) {
  if (complementary_parameter == 0.0) {
    const double root = std::sqrt(r - 1.0);
    return root == 0.0 ? at.sn : std::atan(root * at.sn) / root;
  }
  // Carlson's connection formula (DLMF 19.21.12) leads here from the share of sn², which is almost
  // all of u where r is large.
  const double s = std::abs(at.sn);
  const double x = at.cn * at.cn;
  const double y = at.dn * at.dn;
  const double p = x + r * s * s;
  const double q = x + complementary_parameter * s * s / r;
  const double share = complementary_parameter / r * (s * s * s / 3.0) * carlson_rj(x, y, 1.0, q) +
                       s * std::abs(at.cn) * carlson_rc(y, p * q);
  return std::copysign(share, at.sn);
}

}  // namespace common
