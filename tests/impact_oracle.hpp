#pragma once

#include <optional>

#include "oracle.hpp"

/// When a particle meets a cylinder, by the oracle of lab 4's tests, in the plane's four
/// coordinates.
namespace tests {

/// A motion in the yz-plane for a time dt, a particle's and a cylinder's radius.
struct Query {
  double y, z, v_y, v_z;
  double R, r;
  double dt;
};

struct Impact {
  Digits100 time;
  bool deep = false;  ///< nearer to the axis than ρ/2: the root is well conditioned
};

inline std::optional<Impact> impact(const Query& q) {
  const Quadratic f = quadratic({{q.y, q.v_y}, {q.z, q.v_z}}, q.R, q.r);
  const std::optional<Digits100> time = first_time(f, q.dt);
  if (!time) return std::nullopt;
  const cpp_int touching = f.rho_squared * f.a;  // (x × v)² of a path that touches
  return Impact{*time, f.c > 0 && 4 * (touching - discriminant(f)) <= touching};
}

}  // namespace tests
