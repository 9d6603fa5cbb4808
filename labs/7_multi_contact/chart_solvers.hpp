#pragma once

#include <cmath>
#include <exception>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "peers.hpp"
#include "touching_balls.hpp"

/// Balls that fall on one another and on a floor, and what comes to rest by a solver. All of it
/// comes to rest if the solver gets to its end.
namespace lab::multi_contact {

inline constexpr double radius = 0.5;
inline constexpr double fall = 1.0;  ///< [m/s]

/// The first body is immovable and has the walls, the others are balls.
struct Falling {
  std::vector<RigidBody> bodies{immovable()};
  std::vector<Wall> walls;
  std::vector<Contact> contacts{};  ///< walls first, then from the foot up
};

inline Falling with_contacts(Falling falling) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 1; i < falling.bodies.size(); ++i) {
    const Vec3& center = falling.bodies[i].position;
    for (const Wall& wall : falling.walls) {
      if (wall.normal.dot(center) - wall.offset > radius + rounding) continue;
      falling.contacts.push_back(
          {0, static_cast<int>(i), center - radius * wall.normal, wall.normal});
    }
  }
  for (const NearContact& near : near_balls(falling.bodies, 1, radius, rounding)) {
    falling.contacts.push_back(near.contact);
  }
  return falling;
}

inline Falling column(int count) {
  Falling falling;
  falling.walls = {{Vec3::UnitZ(), 0.0}};
  for (int i = 0; i < count; ++i) {
    falling.bodies.push_back(ball_at({0.0, 0.0, radius * (2.0 * i + 1.0)}, {0.0, 0.0, -fall}));
  }
  return with_contacts(falling);
}

/// Rows of `side` balls in the x-z plane, each row lying in the gaps of the one below, in a box.
/// Speeds differ at random by up to 0.3 of the fall, in each component.
inline Falling box_of_balls(int side) {
  std::mt19937 engine(7);
  const auto noise = [&] {  // the same on every platform
    return 0.3 * (static_cast<double>(engine()) / 2147483648.0 - 1.0) * fall;
  };
  Falling falling;
  falling.walls = {
      {Vec3::UnitZ(), 0.0}, {Vec3::UnitX(), 0.0}, {-Vec3::UnitX(), -radius * (2.0 * side + 1.0)}};
  for (int row = 0; row < side; ++row) {
    for (int i = 0; i < side; ++i) {
      const Vec3 place(2.0 * i + 1.0 + row % 2, 0.0, 1.0 + std::sqrt(3.0) * row);
      const double sideways = noise();
      falling.bodies.push_back(ball_at(radius * place, {sideways, 0.0, noise() - fall}));
    }
  }
  return with_contacts(falling);
}

/// The speed that is left, as root of the mean square over the balls, as a share of the fall.
inline double speed_left(const std::vector<Vec3>& velocities) {
  double sum = 0.0;
  for (const Vec3& v : velocities) sum += v.squaredNorm();
  return std::sqrt(sum / static_cast<double>(velocities.size())) / fall;
}

/// A scene whose system is made when it is first wanted: it may not be written yet.
class Problem {
 public:
  explicit Problem(Falling falling) : falling_(std::move(falling)) {}

  [[nodiscard]] const Falling& falling() const { return falling_; }
  const ContactSystem& system() {
    if (!system_) {
      system_ = std::make_unique<ContactSystem>(contact_system(falling_.bodies, falling_.contacts));
    }
    return *system_;
  }
  [[nodiscard]] double error(const Vector& lambda) const {
    const std::vector<RigidBody> after = with_impulses(falling_.bodies, falling_.contacts, lambda);
    std::vector<Vec3> velocities;
    for (std::size_t i = 1; i < after.size(); ++i) velocities.push_back(after[i].velocity);
    return speed_left(velocities);
  }

 private:
  Falling falling_;
  std::unique_ptr<ContactSystem> system_;
};

using SharedProblem = std::shared_ptr<Problem>;

/// λ of a system after so many sweeps or steps.
using Solver = std::function<Vector(const ContactSystem& system, int count)>;

inline Vector by_gauss_seidel(const ContactSystem& system, int sweeps) {
  return gauss_seidel(system.A, system.u, Vector::Zero(system.u.size()), sweeps);
}

/// All contacts from the λ of the sweep before, and half the way: the whole way may diverge.
inline Vector by_jacobi(const ContactSystem& system, int sweeps) {
  const Vector half_steps = 0.5 * system.A.diagonal().cwiseInverse();
  Vector lambda = Vector::Zero(system.u.size());
  for (int i = 0; i < sweeps; ++i) {
    const Vector u = common::product(system.A, lambda) + system.u;
    lambda = (lambda - half_steps.cwiseProduct(u)).cwiseMax(0.0);
  }
  return lambda;
}

inline Vector by_acceleration(const ContactSystem& system, int steps) {
  return accelerated(system.A, system.u, steps);
}

inline Vector by_active_set(const ContactSystem& system, int /*once*/) {
  try {
    return common::complementary(system.A, system.u);
  } catch (const std::exception&) {  // a wrong system may have no solution
    return Vector::Zero(system.u.size());
  }
}

}  // namespace lab::multi_contact
