#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "scene_models.hpp"

/// The break of fifteen balls under a model: free flights in the plane between impacts, each at the
/// time of impact.
namespace lab::multi_contact {

inline constexpr double rack_radius = 0.075;
inline constexpr double cue_speed = 1.0;       ///< [m/s]
inline constexpr double break_duration = 1.3;  ///< [s]
inline constexpr int rack_rows = 5;

struct FreeFlight {
  double start = 0.0;  ///< [s]
  std::vector<RigidBody> balls;
};

struct Break {
  std::vector<FreeFlight> flights;
  Ledger ledger;
  double asymmetry = 0.0;  ///< after the first impact, see asymmetry()
};

/// The cue ball below the rack's tip, flying up the table; then row by row, from left to right.
inline std::vector<RigidBody> racked() {
  const double row = std::sqrt(3.0) * rack_radius;
  std::vector<RigidBody> balls{ball_at({0.0, -6.5 * rack_radius, 0.0}, {0.0, cue_speed, 0.0})};
  for (int i = 0; i < rack_rows; ++i) {
    for (int k = 0; k <= i; ++k) {
      balls.push_back(ball_at({(2.0 * k - i) * rack_radius, row * i, 0.0}, Vec3::Zero()));
    }
  }
  return balls;
}

/// When two balls touch that fly towards each other; infinity if they do not meet.
inline double meeting(const RigidBody& a, const RigidBody& b, double radius) {
  const Vec3 x = b.position - a.position;
  const Vec3 v = b.velocity - a.velocity;
  const double closing = -x.dot(v);  // (x + t v)² = (2 r)²
  const double apart = x.squaredNorm() - 4.0 * radius * radius;
  const double root = closing * closing - v.squaredNorm() * apart;
  const bool meet = closing > 1e-9 * x.norm() && root >= 0.0;
  return meet ? std::max(0.0, apart / (closing + std::sqrt(root)))
              : std::numeric_limits<double>::infinity();
}

inline std::vector<RigidBody> flown(std::vector<RigidBody> balls, double time) {
  for (RigidBody& ball : balls) ball.position += time * ball.velocity;
  return balls;
}

/// Each ball of the rack has its mirror image in the same row: by how much a component of their
/// velocities differs at most, as a share of the cue ball's speed.
inline double asymmetry(const std::vector<RigidBody>& balls) {
  double largest = 0.0;
  grow(largest, 2.0 * std::abs(balls[0].velocity.x()));
  std::size_t first = 1;
  for (std::size_t i = 0; i < rack_rows; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      Vec3 image = balls[first + i - k].velocity;
      image.x() = -image.x();
      const Vec3 off = balls[first + k].velocity - image;
      for (const double component : off) grow(largest, std::abs(component));
    }
    first += i + 1;
  }
  return largest / cue_speed;
}

inline Break broken(const Model& model) {
  constexpr int most_impacts = 200;  // of a wrong answer, whose balls may never part
  Break result;
  result.flights.push_back({0.0, racked()});
  while (result.ledger.impacts < most_impacts) {
    const FreeFlight& last = result.flights.back();
    double next = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < last.balls.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        next = std::min(next, meeting(last.balls[a], last.balls[b], rack_radius));
      }
    }
    if (!(last.start + next < break_duration)) break;
    const FreeFlight flight{last.start + next, after_impact(model, flown(last.balls, next),
                                                            rack_radius, result.ledger)};
    if (result.ledger.impacts == 1) result.asymmetry = asymmetry(flight.balls);
    result.flights.push_back(flight);
  }
  return result;
}

}  // namespace lab::multi_contact
