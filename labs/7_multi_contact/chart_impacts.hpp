#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/chart/record.hpp"
#include "touching_balls.hpp"

/// How many impulses an impact takes, and where a block slides.
namespace lab::multi_contact {

// Inelastic collapse.

/// Equal balls in a row, the first of which hits the others.
inline ContactSystem row_of_balls(int count) {
  std::vector<RigidBody> balls;
  std::vector<Contact> contacts;
  for (int i = 0; i < count; ++i) {
    balls.push_back(ball_at({1.0 * i, 0.0, 0.0}, i == 0 ? Vec3(1.0, 0.0, 0.0) : Vec3::Zero()));
    if (i > 0) contacts.push_back({i - 1, i, {i - 0.5, 0.0, 0.0}, Vec3::UnitX()});
  }
  return contact_system(balls, contacts);
}

/// Below it the row can collide without end: tan²(π/4 (1 − 2/N)).
inline double collapse_below(int balls) {
  const double root = std::tan(0.25 * std::numbers::pi * (1.0 - 2.0 / balls));
  return root * root;
}

inline constexpr int most_impulses = 1000;

/// Impulses until nothing approaches, or most_impulses. A contact that approaches by 1e-12 of the
/// first speeds counts as one that does not, and so even a collapse would end. So after some whole
/// sweeps what is left begins anew, at a size of 1.
inline int impulses_until_apart(ContactSystem system, double restitution) {
  constexpr int at_a_time = 12;
  int count = 0;
  while (count < most_impulses) {
    const Impulses done = sequential_impulses(system, restitution, at_a_time);
    if (done.count == 0) return count;
    count += done.count;
    system.u += common::product(system.A, done.lambda);
    system.u /= common::largest_entry(system.u);
  }
  return most_impulses;
}

/// `count_of` a row and e, for e up to 1, close to one another at the collapse.
template <typename Count>
render::History counts_by_restitution(int balls, const Count& count_of) {
  const ContactSystem row = row_of_balls(balls);
  render::History counts{{}, {{}}, ""};
  const auto add = [&](double e) {
    counts.times.push_back(e);
    counts.values[0].push_back(count_of(row, e));
  };
  constexpr int coarse = 500;
  constexpr int close = 150;
  const double least = collapse_below(balls);
  const auto below = static_cast<int>(coarse * least);
  for (int i = 1; i <= below; ++i) add(static_cast<double>(i) / coarse);
  for (int i = 0; i < close; ++i) add(least + std::pow(10.0, -6.0 + 3.0 * i / close));
  for (int i = below + 2; i <= coarse; ++i) add(static_cast<double>(i) / coarse);
  return counts;
}

/// A line straight up where the collapse begins.
inline render::History collapse_wall(int balls) {
  const double least = collapse_below(balls);
  return {{least, least + 1e-9}, {{1.0, most_impulses}}, "e_c"};
}

// Counting π.

inline constexpr double largest_root = 12.0;  // of the mass ratio

/// A ball of 1 kg rests at a wall, and one of root² kg comes.
inline ContactSystem wall_and_two_balls(double root) {
  std::vector<RigidBody> bodies{immovable(), ball_at(Vec3::Zero(), Vec3::Zero()),
                                ball_at({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0})};
  bodies[2].inverse_mass = 1.0 / (root * root);
  return contact_system(
      bodies, {{0, 1, {-0.5, 0.0, 0.0}, Vec3::UnitX()}, {1, 2, {0.5, 0.0, 0.0}, Vec3::UnitX()}});
}

/// `count_of` a system, against the root of the mass ratio.
template <typename Count>
render::History counts_by_mass(const Count& count_of) {
  constexpr int steps_of_one = 200;
  render::History counts{{}, {{}}, ""};
  for (int i = steps_of_one; i <= largest_root * steps_of_one; ++i) {
    const double root = static_cast<double>(i) / steps_of_one;
    counts.times.push_back(root);
    counts.values[0].push_back(count_of(wall_and_two_balls(root)));
  }
  return counts;
}

inline render::History pi_times_root() {
  return {{1.0, largest_root}, {{std::numbers::pi, largest_root * std::numbers::pi}}, ""};
}

// Slides.

/// The way of a block that slides at an angle to the tangents until it rests, in v²/(2 μ g).
inline Vec2 slide(FrictionRule rule, double angle) {
  constexpr int steps = 2000;
  constexpr double friction = 0.5;
  Vec2 v(std::cos(angle), std::sin(angle));
  Vec2 way = Vec2::Zero();
  const Matrix A = Matrix::Identity(3, 3);
  Vector b(3);
  for (int i = 0; i < 2 * steps && v.norm() > 1e-9; ++i) {
    b << -1.0 / (friction * steps), v;  // g dt, so that μ g dt is a share 1/steps of the speed
    const Vector lambda = friction_sweeps(A, b, Vector::Zero(3), friction, rule, 1);
    const Vec2 next = v + lambda.tail<2>();
    way += (v + next) / steps;
    v = next;
  }
  return way;
}

/// Each component is braked by μ g.
inline Vec2 box_way(double angle) {
  return {std::pow(std::cos(angle), 2), std::pow(std::sin(angle), 2)};
}

/// The larger component alone is braked, until both are equal; then both by half.
inline Vec2 diamond_way(double angle) {
  const double smaller = std::sin(2.0 * angle);
  return std::cos(angle) > std::sin(angle) ? Vec2(1.0, smaller) : Vec2(smaller, 1.0);
}

inline double degrees(double angle) { return 180.0 / std::numbers::pi * angle; }

/// By how much a way is off the direction of its start, against that direction [°].
template <typename Way>
render::History directions(const Way& way_of) {
  constexpr int last = 80;  // at 90° all lines meet
  render::History history{{}, {{}}, ""};
  for (int i = 0; i <= 2 * last; ++i) {
    const double angle = std::numbers::pi / 360.0 * i;
    const Vec2 way = way_of(angle);
    history.times.push_back(0.5 * i);
    const double off = degrees(std::atan2(way.y(), way.x()) - angle);
    history.values[0].push_back(std::isfinite(off) ? off : 180.0);
  }
  return history;
}

/// The box's and the diamond's largest error: tan φ + cot φ = 1 + √3 there, for the box.
inline double largest_direction_error() {
  const double sum = 1.0 + std::numbers::sqrt3;
  const double angle = std::atan(0.5 * (sum - std::sqrt(sum * sum - 4.0)));
  return angle - std::atan(std::pow(std::tan(angle), 2));
}

}  // namespace lab::multi_contact
