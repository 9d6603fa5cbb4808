#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "oracle.hpp"
#include "trial.hpp"

/// How what the lab's functions return is printed and judged, and the mistakes that it may show.
namespace tests {

using common::ParticleContact;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

namespace story {

inline const std::string no_r = "the particle's radius is missing: subtract R + r, not R";
inline const std::string no_radii = "this is the distance from the axis: subtract R + r";
inline const std::string keeps_x =
    "x is kept in the distance: leave it out, because nothing changes along the cylinder";
inline const std::string reversed_gap = "the sign is reversed: the gap is above zero outside";
inline const std::string underflow =
    "the squares vanish, because 1e-200 squared is 0: use std::hypot";
inline const std::string near_axis =
    "a point near the axis is taken for one on it: test only for a distance of exactly zero";
inline const std::string touching = "touching counts: a gap of exactly zero is a contact";
inline const std::string tolerance =
    "a tolerance is added: leave it out, because a gap above zero is not a contact";
inline const std::string no_time = "the time is not passed on: set the contact's time";
inline const std::string unchecked = "this argument is not checked: see common/course/require.hpp";

}  // namespace story

/// Whether there is a contact.
struct Presence {
  std::optional<ParticleContact> contact;
};

inline bool is_finite(const Presence& value) {
  const auto& c = value.contact;
  return !c || (is_finite(c->point_on_cylinder) && is_finite(c->point_on_particle) &&
                is_finite(c->normal) && is_finite(c->gap) && is_finite(c->time));
}
inline double length(const Presence&) { return 0.0; }
inline double difference(const Presence& a, const Presence& b) {
  return a.contact.has_value() == b.contact.has_value() ? 0.0 : 1.0;
}
inline std::string text(const Presence& value) {
  if (!value.contact) return "no contact";
  return "a contact with gap " + text(value.contact->gap) + " at time " + text(value.contact->time);
}

/// Indices in their order.
struct IndexList {
  std::vector<std::size_t> indices;
};

/// What −1 or NaN become as an index is no index.
inline bool is_finite(const IndexList& list) {
  return std::none_of(list.indices.begin(), list.indices.end(), [](std::size_t index) {
    return index > std::numeric_limits<std::size_t>::max() / 2;
  });
}
inline double length(const IndexList&) { return 0.0; }
inline double difference(const IndexList& a, const IndexList& b) {
  return a.indices == b.indices ? 0.0 : 1.0;
}
inline std::string text(const IndexList& list) {
  std::string entries;
  for (std::size_t i = 0; i < std::min<std::size_t>(list.indices.size(), 20); ++i) {
    entries += (i == 0 ? "" : ", ") + std::to_string(list.indices[i]);
  }
  if (list.indices.size() > 20) entries += ", ... (" + std::to_string(list.indices.size()) + ")";
  return "{" + entries + "}";
}

/// A list of positions, pasteable where it is short.
struct Positions {
  std::vector<Vec3> positions;
};

inline std::string text(const Positions& list) {
  if (list.positions.size() > 12) return std::to_string(list.positions.size()) + " positions";
  std::string entries;
  for (const Vec3& position : list.positions) {
    entries += (entries.empty() ? "" : ", ") + text(position);
  }
  return "{" + entries + "}";
}

/// One particle and the cylinder.
struct Meeting {
  Vec3 position = Vec3::Zero();
  double particle_radius = 0.5;
  Cylinder cylinder;
  double time = 0.0;

  [[nodiscard]] double gap() const { return exact_gap(position, particle_radius, cylinder); }
  /// What rounding is relative to.
  [[nodiscard]] double size() const {
    return rounded(distance(position) + rho(particle_radius, cylinder));
  }
};

/// A particle at `distance` times R + r.
inline Meeting random_meeting(Random& random, double distance) {
  Meeting m;
  m.cylinder.radius = random.uniform(0.2, 2.0);
  m.particle_radius = random.uniform(0.05, 1.0);
  m.position =
      around_axis(random.uniform(-3.0, 3.0), distance * (m.cylinder.radius + m.particle_radius),
                  random_angle(random));
  m.time = random.uniform(-2.0, 2.0);
  return m;
}

inline Trial radii_trial(const char* function, double particle_radius, const Cylinder& cylinder,
                         int index = 1, int count = 1) {
  return Trial(function, index, count)
      .given("particle_radius", particle_radius)
      .given("cylinder.radius", cylinder.radius);
}

inline Trial trial_of(const char* function, const Meeting& m, int index = 1, int count = 1) {
  return radii_trial(function, m.particle_radius, m.cylinder, index, count)
      .given("position", m.position);
}

inline Bound few_ulp(double size) {
  return {4.0 * eps * size, "a few roundings on lengths of this size"};
}

/// Why a distance is taken for zero, from what a function makes of 5e-100, whose square is a
/// double. wrong_there  of no argument; it may throw where that function is not written yet
template <typename Wrong>
std::string why_zero(const Wrong& wrong_there) {
  try {
    return wrong_there() ? story::near_axis : story::underflow;
  } catch (const std::exception&) {
    return story::underflow;
  }
}
inline std::string why_gap_has_no_distance() {
  return why_zero([] {
    const Vec3 p(0.0, 3e-100, 4e-100);
    return std::abs(lab::discrete_particle_cylinder::gap(p, 1e-100, {1e-100}) - 3e-100) > 1e-112;
  });
}

inline std::vector<Suspect<double>> suspects_of_gap(const Meeting& m) {
  const Exact d = distance(m.position);
  const Exact sum = rho(m.particle_radius, m.cylinder);
  const Exact x = m.position.x();
  return {{rounded(d - m.cylinder.radius), story::no_r},
          {rounded(d), story::no_radii},
          {rounded(sqrt(x * x + d * d) - sum), story::keeps_x},
          {rounded(sum - d), story::reversed_gap},
          {rounded(d - m.cylinder.radius + m.particle_radius),
           "the particle's radius is added to the gap: subtract it"},
          {rounded(-sum), why_gap_has_no_distance()}};
}

/// (0, y, z)/√(y² + z²), +y on the axis.
inline Vec3 exact_gradient(const Vec3& p) {
  const Exact d = distance(p);
  if (d == 0) return Vec3::UnitY();
  return {0.0, rounded(p.y() / d), rounded(p.z() / d)};
}

/// Judges a contact that must be there, part by part.
/// slack  by how much the particle's position may be off [m]
inline void expect_contact(const Trial& trial, const std::optional<ParticleContact>& got,
                           const Meeting& m, double slack = 0.0) {
  trial.expect(Presence{got}, Presence{ParticleContact{}},
               {0.0, "the gap is not above zero, so there is a contact"});
  const Vec3 n = exact_gradient(m.position);
  const Vec3 axis_point(m.position.x(), 0.0, 0.0);
  const double R = m.cylinder.radius;
  const double r = m.particle_radius;
  const double far = rounded(distance(m.position));
  const double turned = 8.0 * eps + (far > 0.0 ? 2.0 * slack / far : 0.0);
  const double along = slack + 8.0 * eps * (length(m.position) + R + r);
  const Vec3 whole = length(m.position) > 0.0 ? Vec3(m.position / length(m.position)) : n;

  trial.of("the normal")
      .expect(got->normal, n, {turned, "a few roundings of a unit vector"},
              {{Vec3(-n), "the normal points into the cylinder: change its sign"},
               {whole, story::keeps_x},
               {Vec3(Vec3::Zero()), "it is zero on the axis: return +y there"}});
  trial.of("the point on the cylinder")
      .expect(got->point_on_cylinder, Vec3(axis_point + R * n),
              {along + R * turned, "R times the normal's rounding, and that of x"},
              {{Vec3(R * n), "x is lost: use the particle's x, not 0"},
               {Vec3(axis_point + (R + r) * n), "it is R + r from the axis: the surface is at R"},
               {Vec3(axis_point - R * n),
                "it is on the far side of the cylinder: go from the axis along +n"},
               {m.position, "it is the particle's centre: go from the axis along n by R"}});
  trial.of("the point on the particle")
      .expect(got->point_on_particle, Vec3(m.position - r * n),
              {along + r * turned, "r times the normal's rounding, and that of the position"},
              {{Vec3(m.position + r * n), "it is on the far side of the particle: subtract r n"},
               {m.position, "it is the particle's centre: subtract r n"},
               {Vec3(axis_point + R * n),
                "it is the point on the cylinder: subtract r n from the position instead"}});
  trial.of("the gap").expect(got->gap, m.gap(), {slack + 4.0 * eps * m.size(), "as in step 3.1"},
                             [&] { return suspects_of_gap(m); });
  trial.of("the time")
      .expect(got->time, m.time,
              {2.0 * eps * std::abs(m.time), "the time that was passed in, or k T/N"},
              {{0.0, story::no_time}});
}

/// Requires std::invalid_argument for each radius that none can be.
/// call  of (particle_radius, cylinder), as a value of a trial
template <typename Call>
void expect_radii_checked(const char* function, const Call& call) {
  int index = 0;
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    radii_trial(function, bad, {1.0}, ++index, 8)
        .expect_throw([&] { return call(bad, Cylinder{1.0}); },
                      "a particle's radius must be finite and above zero", story::unchecked);
    radii_trial(function, 0.5, {bad}, ++index, 8)
        .expect_throw([&] { return call(0.5, Cylinder{bad}); },
                      "a cylinder's radius must be finite and above zero", story::unchecked);
  }
}

/// Requires std::invalid_argument for each coordinate that is NaN or infinite, along x as well.
/// call  of a position, as a value of a trial
template <typename Call>
void expect_position_checked(const char* function, const char* name, const Call& call) {
  int index = 0;
  for (const double bad : {nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 position(0.5, -0.25, 0.75);
      position(axis) = bad;
      Trial(function, ++index, 9)
          .given(name, position)
          .expect_throw([&] { return call(position); }, "every entry must be finite",
                        story::unchecked);
    }
  }
}

}  // namespace tests
