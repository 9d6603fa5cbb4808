#include "common/exact/orientation.hpp"

#include <cmath>

#include "common/exact/exact_number.hpp"

namespace common {
namespace {

// Shewchuk 1997, Discrete & Computational Geometry 18: a determinant of rounded differences errs by
// less than these times the sum of its products' sizes.
constexpr double u = 0x1p-53;
constexpr double bound_of_volume = (7.0 + 56.0 * u) * u;
constexpr double bound_of_area = (3.0 + 16.0 * u) * u;
/// More than a few products lose by underflow, relative to the factor that is left.
constexpr double underflow = 1e-300;

int sign(double value) { return (value > 0.0) - (value < 0.0); }

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  using Exact = ExactNumber;
  const auto difference = [&](const Vec3& p, int i) { return Exact(p[i]) - Exact(d[i]); };
  const Exact ax = difference(a, 0), ay = difference(a, 1), az = difference(a, 2);
  const Exact bx = difference(b, 0), by = difference(b, 1), bz = difference(b, 2);
  const Exact cx = difference(c, 0), cy = difference(c, 1), cz = difference(c, 2);
  return -((by * cz - bz * cy) * ax + (cy * az - cz * ay) * bx + (ay * bz - az * by) * cx).sign();
}

int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  using Exact = ExactNumber;
  const Exact acx = Exact(a.x()) - Exact(c.x()), acy = Exact(a.y()) - Exact(c.y());
  const Exact bcx = Exact(b.x()) - Exact(c.x()), bcy = Exact(b.y()) - Exact(c.y());
  return (acx * bcy - acy * bcx).sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 p = a - d;
  const Vec3 q = b - d;
  const Vec3 r = c - d;
  const double q_r = q.y() * r.z(), r_q = q.z() * r.y();
  const double r_p = r.y() * p.z(), p_r = r.z() * p.y();
  const double p_q = p.y() * q.z(), q_p = p.z() * q.y();
  const double volume = (q_r - r_q) * p.x() + (r_p - p_r) * q.x() + (p_q - q_p) * r.x();
  const double x = std::abs(p.x()), y = std::abs(q.x()), z = std::abs(r.x());
  const double size = (std::abs(q_r) + std::abs(r_q)) * x + (std::abs(r_p) + std::abs(p_r)) * y +
                      (std::abs(p_q) + std::abs(q_p)) * z;
  if (std::abs(volume) > bound_of_volume * size + underflow * (1.0 + x + y + z)) {
    return -sign(volume);
  }
  // Neighbours in a mesh and walls along the axes need no more digits.
  if (d == a || d == b || d == c) return 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (p[i] == 0.0 && q[i] == 0.0 && r[i] == 0.0) return 0;
  }
  return exact_orientation(a, b, c, d);
}

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  if (std::abs(area) > bound_of_area * (std::abs(left) + std::abs(right)) + underflow) {
    return sign(area);
  }
  if ((a.x() == c.x() && b.x() == c.x()) || (a.y() == c.y() && b.y() == c.y())) return 0;
  return exact_orientation(a, b, c);
}

}  // namespace common
