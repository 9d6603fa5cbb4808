#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "scene_models.hpp"

/// Newton's cradle under a model: equal pendulums that touch at the bottom. They swing by the law
/// of small angles, so all of them are at the bottom at one time, however far each of them went.
namespace lab::multi_contact {

inline constexpr int cradle_balls = 5;
inline constexpr double cradle_radius = 0.11;
inline constexpr double cord = 0.8;       ///< from the pivot to the centre of a ball [m]
inline constexpr double lifted_by = 0.6;  ///< the first ball, at the start [rad]
inline const double frequency = std::sqrt(9.81 / cord);  ///< [rad/s]
inline const double period = 2.0 * std::numbers::pi / frequency;
inline constexpr int half_swings = 4;

/// From the bottom to the bottom.
struct Swing {
  double start = 0.0;        ///< at the bottom [s]
  std::vector<Vec3> speeds;  ///< of each ball there [m/s]

  [[nodiscard]] double angle(std::size_t ball, double time) const {
    return speeds[ball].y() / (frequency * cord) * std::sin(frequency * (time - start));
  }
};

struct Cradle {
  std::vector<Swing> swings;
  Ledger ledger;
};

/// What hangs at the bottom when a swing ends: each ball comes back as fast as it left.
inline std::vector<RigidBody> at_the_bottom(const Swing& swing) {
  std::vector<RigidBody> balls;
  for (std::size_t i = 0; i < swing.speeds.size(); ++i) {
    const Vec3 place(0.0, 2.0 * cradle_radius * static_cast<double>(i), 0.0);
    balls.push_back(ball_at(place, -swing.speeds[i]));
  }
  return balls;
}

/// Let go at time 0, as if the first ball had left the bottom a quarter of a period before.
inline Cradle swung(const Model& model) {
  Cradle cradle;
  cradle.swings.push_back({-0.25 * period, std::vector<Vec3>(cradle_balls, Vec3::Zero())});
  cradle.swings[0].speeds[0].y() = -lifted_by * frequency * cord;
  for (int i = 1; i < half_swings; ++i) {
    Swing next{cradle.swings.back().start + 0.5 * period, {}};
    const std::vector<RigidBody> balls = at_the_bottom(cradle.swings.back());
    for (const RigidBody& ball : after_impact(model, balls, cradle_radius, cradle.ledger)) {
      next.speeds.push_back(ball.velocity);
    }
    cradle.swings.push_back(next);
  }
  return cradle;
}

}  // namespace lab::multi_contact
