#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>

/// When a particle meets a cylinder, in whole numbers and 100 digits: the judge of lab 4's answers,
/// with which it shares no code.
namespace tests {

using Whole = boost::multiprecision::cpp_int;
using Digits = boost::multiprecision::cpp_bin_float_100;

/// A motion in the yz-plane for a time dt, a particle's and a cylinder's radius.
struct Query {
  double y, z, v_y, v_z;
  double R, r;
  double dt;
};

/// The power of two of which a double is a whole multiple.
inline int unit_of(double value) {
  if (value == 0.0) return std::numeric_limits<int>::max();
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::max(exponent - 53, -1074);
}

inline Whole in_units(double value, int unit) {
  if (value == 0.0) return 0;
  const int own = unit_of(value);
  return Whole(static_cast<long long>(std::ldexp(value, -own)))
         << static_cast<unsigned>(own - unit);
}

struct Impact {
  Digits time;
  bool deep = false;  ///< nearer to the axis than ρ/2: the root is well conditioned
};

class ImpactOracle {
 public:
  explicit ImpactOracle(const Query& q)
      : length_unit_(std::min({unit_of(q.y), unit_of(q.z), unit_of(q.R), unit_of(q.r)})),
        speed_unit_(std::min(unit_of(q.v_y), unit_of(q.v_z))) {
    y_ = in_units(q.y, length_unit_);
    z_ = in_units(q.z, length_unit_);
    rho_ = in_units(q.R, length_unit_) + in_units(q.r, length_unit_);
    if (moves()) {
      v_y_ = in_units(q.v_y, speed_unit_);
      v_z_ = in_units(q.v_z, speed_unit_);
    }
    // t = ticks 2^(time_unit_), and a tick takes the particle 2^shift units of length at speed one.
    time_unit_ = length_unit_ - speed_unit_;
    dt_ = q.dt;
  }

  [[nodiscard]] std::optional<Impact> impact() const {
    const Whole c = y_ * y_ + z_ * z_ - rho_ * rho_;
    if (c <= 0) return Impact{0, false};
    if (!moves()) return std::nullopt;
    const Whole a = v_y_ * v_y_ + v_z_ * v_z_;
    const Whole b = y_ * v_y_ + z_ * v_z_;
    const Whole w = y_ * v_z_ - z_ * v_y_;
    const Whole reach = rho_ * rho_ * a - w * w;
    if (!inside_at_end() && (b >= 0 || reach < 0 || nearing_at_end())) return std::nullopt;
    const Digits slope = Digits(sqrt(Digits(reach))) - Digits(b);
    return Impact{ldexp(Digits(c) / slope, time_unit_), 4 * w * w <= rho_ * rho_ * a};
  }

 private:
  [[nodiscard]] bool moves() const { return speed_unit_ != std::numeric_limits<int>::max(); }

  /// Lengths times 2^(shift) and how far the particle goes, as whole numbers in one unit.
  struct End {
    Whole y, z, rho;
  };
  [[nodiscard]] End end() const {
    if (dt_ == 0.0) return {y_, z_, rho_};
    const int unit = unit_of(dt_);
    const Whole ticks = in_units(dt_, unit);
    const int shift = unit - time_unit_;  // of what a tick moves against the unit of length
    const auto up_moved = static_cast<unsigned>(std::max(shift, 0));
    const auto up_length = static_cast<unsigned>(std::max(-shift, 0));
    return {(y_ << up_length) + ((ticks * v_y_) << up_moved),
            (z_ << up_length) + ((ticks * v_z_) << up_moved), rho_ << up_length};
  }
  [[nodiscard]] bool inside_at_end() const {
    const End e = end();
    return e.y * e.y + e.z * e.z <= e.rho * e.rho;
  }
  [[nodiscard]] bool nearing_at_end() const {
    const End e = end();
    return e.y * v_y_ + e.z * v_z_ < 0;
  }

  int length_unit_;
  int speed_unit_;
  int time_unit_ = 0;
  double dt_ = 0.0;
  Whole y_, z_, rho_, v_y_, v_z_;
};

/// How far off a time is, in units of the last place of the exact one.
inline double ulps(double got, const Digits& exact) {
  if (exact == 0) return got == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  const int exponent = std::max(static_cast<int>(ilogb(exact)) - 52, -1074);
  return static_cast<double>(Digits(abs(ldexp(Digits(Digits(got) - exact), -exponent))));
}

}  // namespace tests
