#pragma once

#include "oracle.hpp"

/// Inputs of steps 6.1 to 6.3, and what is right for them.
namespace tests {

struct NormalCase {
  double mass;
  common::Vec3 velocity;
  common::Vec3 normal;
  double restitution;
};

inline Real normal_speed(const NormalCase& c) { return wide(c.normal).dot(wide(c.velocity)); }

inline double exact_normal(const NormalCase& c) {
  const Real v_n = normal_speed(c);
  if (v_n >= 0) return 0.0;
  return static_cast<double>(-(1 + wide(c.restitution)) * wide(c.mass) * v_n);
}

struct FrictionCase {
  double mass;
  common::Vec3 velocity;
  common::Vec3 normal;
  double normal_impulse;
  double friction;
};

inline VecL slip(const FrictionCase& c) { return tangential(wide(c.velocity), wide(c.normal)); }
inline Real cone(const FrictionCase& c) { return wide(c.friction) * wide(c.normal_impulse); }

inline common::Vec3 exact_friction(const FrictionCase& c) {
  return narrow(braked(wide(c.mass) * slip(c), cone(c)));
}

struct CorrectionCase {
  common::Vec3 displacement;
  common::Vec3 normal;
  double normal_length;
  double friction;
};

inline VecL slip(const CorrectionCase& c) {
  return tangential(wide(c.displacement), wide(c.normal));
}
inline Real cone(const CorrectionCase& c) { return wide(c.friction) * wide(c.normal_length); }

inline common::Vec3 exact_correction(const CorrectionCase& c) {
  return narrow(braked(slip(c), cone(c)));
}

struct DepthCase {
  double gap;
  common::Vec3 normal;
};

inline common::Vec3 exact_depth(const DepthCase& c) {
  return c.gap < 0.0 ? common::Vec3(-c.gap * c.normal) : common::Vec3(common::Vec3::Zero());
}

}  // namespace tests
