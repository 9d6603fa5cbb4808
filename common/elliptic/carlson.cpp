#include "common/elliptic/carlson.hpp"

#include <algorithm>
#include <cmath>

namespace common {
namespace {

/// (eps / 4)^(-1/6): how much closer than this factor to their mean the arguments must come before
/// the series of fifth order is exact to rounding.
constexpr double closeness = 560.0;

double largest(double a, double b, double c) { return std::max({a, b, c}); }

}  // namespace

double carlson_rc(double x, double y) {
  const double excess = (y - x) / y;
  if (std::abs(excess) < 1e-4) {
    // atan(z) / z with z² = y / x − 1: the next term is below 1e-17.
    const double z_squared = (y - x) / x;
    return (1.0 - z_squared * (1.0 / 3.0 - z_squared * (1.0 / 5.0 - z_squared / 7.0))) /
           std::sqrt(x);
  }
  if (excess > 0.0) return std::atan2(std::sqrt(y - x), std::sqrt(x)) / std::sqrt(y - x);
  const double root = std::sqrt(x - y);
  if (2.0 * y > x) return std::atanh(root / std::sqrt(x)) / root;
  return std::log((std::sqrt(x) + root) / std::sqrt(y)) / root;  // the same, far from equality
}

double carlson_rf(double x, double y, double z) {
  const double mean = (x + y + z) / 3.0;
  const double X0 = mean - x;
  const double Y0 = mean - y;
  const double spread = closeness * largest(std::abs(X0), std::abs(Y0), std::abs(mean - z));
  double A = mean;
  double quarter = 1.0;
  while (quarter * spread >= A) {
    const double lambda =
        std::sqrt(x) * (std::sqrt(y) + std::sqrt(z)) + std::sqrt(y) * std::sqrt(z);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    A = 0.25 * (A + lambda);
    quarter *= 0.25;
  }
  const double X = quarter * X0 / A;
  const double Y = quarter * Y0 / A;
  const double Z = -X - Y;
  const double e_2 = X * Y - Z * Z;
  const double e_3 = X * Y * Z;
  return (1.0 - e_2 / 10.0 + e_3 / 14.0 + e_2 * e_2 / 24.0 - 3.0 * e_2 * e_3 / 44.0) / std::sqrt(A);
}

double carlson_rj(double x, double y, double z, double p) {
  const double mean = (x + y + z + 2.0 * p) / 5.0;
  const double X0 = mean - x;
  const double Y0 = mean - y;
  const double Z0 = mean - z;
  const double spread =
      closeness * std::max(largest(std::abs(X0), std::abs(Y0), std::abs(Z0)), std::abs(mean - p));
  double A = mean;
  double quarter = 1.0;
  double sum = 0.0;
  while (quarter * spread >= A) {
    const double root_x = std::sqrt(x);
    const double root_y = std::sqrt(y);
    const double root_z = std::sqrt(z);
    const double root_p = std::sqrt(p);
    const double lambda = root_x * (root_y + root_z) + root_y * root_z;
    const double d = (root_p + root_x) * (root_p + root_y) * (root_p + root_z);
    // 1 + (p − x)(p − y)(p − z) / d² without its cancellation for small p.
    sum += quarter / d * carlson_rc(1.0, 2.0 * root_p * (p + lambda) / d);
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
    p = 0.25 * (p + lambda);
    A = 0.25 * (A + lambda);
    quarter *= 0.25;
  }
  const double X = quarter * X0 / A;
  const double Y = quarter * Y0 / A;
  const double Z = quarter * Z0 / A;
  const double P = -0.5 * (X + Y + Z);
  const double e_2 = X * Y + X * Z + Y * Z - 3.0 * P * P;
  const double e_3 = X * Y * Z + 2.0 * e_2 * P + 4.0 * P * P * P;
  const double e_4 = (2.0 * X * Y * Z + e_2 * P + 3.0 * P * P * P) * P;
  const double e_5 = X * Y * Z * P * P;
  const double series = 1.0 - 3.0 * e_2 / 14.0 + e_3 / 6.0 + 9.0 * e_2 * e_2 / 88.0 -
                        3.0 * e_4 / 22.0 - 9.0 * e_2 * e_3 / 52.0 + 3.0 * e_5 / 26.0;
  return quarter * series / (A * std::sqrt(A)) + 6.0 * sum;
}

}  // namespace common
