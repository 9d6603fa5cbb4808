#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "common/contact/obstacle.hpp"
#include "common/course/if_written.hpp"
#include "scene_models.hpp"

/// Balls pour on the cylinder of labs 3 to 6, between two panes and two walls, and come to rest.
/// Each step in time is one problem of all contacts, see step().
namespace lab::multi_contact {

inline constexpr int pile_balls = 300;
inline constexpr double pile_radius = 0.08;
inline constexpr double half_width = 2.1;  ///< from the middle to a wall [m]
inline constexpr double pile_duration = 5.0;
inline constexpr int steps_a_second = 240;
inline constexpr double dt = 1.0 / steps_a_second;
inline constexpr int sweeps = 24;
inline constexpr double weight = 9.81;  ///< of a ball [N]
inline const Vec3 gravity(0.0, 0.0, -weight);

/// What stands there, for a ball's centre.
inline std::vector<common::Obstacle> pile_obstacles() {
  const double y = half_width - pile_radius;
  return {common::Plane{{0.0, 0.0, pile_radius - 1.5}, Vec3::UnitZ()},
          common::Plane{{0.0, -y, 0.0}, Vec3::UnitY()},
          common::Plane{{0.0, y, 0.0}, -Vec3::UnitY()}, common::Cylinder{1.0 + pile_radius}};
}

/// Every 0.075 s a row of balls, a little displaced at random, else they would lie as they fell.
inline void pour(std::vector<RigidBody>& bodies, std::mt19937& engine, double time) {
  constexpr int row = 12;
  constexpr double between_rows = 0.075;
  for (auto i = static_cast<int>(bodies.size()) - 1; i < pile_balls; ++i) {
    const int rows_before = i / row;
    if (rows_before * between_rows > time) return;
    const double random = static_cast<double>(engine()) / 4294967296.0;  // the same everywhere
    const double place = i % row - 0.5 * (row - 1) + (rows_before % 2 == 0 ? 0.25 : -0.25);
    const double y = (2.1 * place + 0.08 * (random - 0.5)) * pile_radius;
    bodies.push_back(ball_at({0.0, y, 2.2}, {0.0, 0.0, -2.2}));
  }
}

inline constexpr double most_outwards = 1.0;  ///< speed at which overlaps are moved out [m/s]

/// All contacts that may close within a step, if no ball becomes faster than the fastest one or
/// than what is moved out. Others may squeeze a ball out faster; then the next step sees its
/// contacts.
inline std::vector<NearContact> near_contacts(const std::vector<RigidBody>& bodies) {
  double fastest = most_outwards;
  for (const RigidBody& body : bodies) grow(fastest, body.velocity.norm());
  const double reach = 2.0 * dt * fastest;
  static const std::vector<common::Obstacle> obstacles = pile_obstacles();
  std::vector<NearContact> found;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const Vec3& center = bodies[i].position;
    for (const common::Obstacle& obstacle : obstacles) {
      const double gap = common::gap(obstacle, center);
      if (!(gap < reach)) continue;
      const Vec3 normal = common::outward_normal(obstacle, center);
      found.push_back({{0, static_cast<int>(i), center - pile_radius * normal, normal}, gap});
    }
  }
  const std::vector<NearContact> between = near_balls(bodies, 1, pile_radius, reach);
  found.insert(found.end(), between.begin(), between.end());
  return found;
}

/// A ball in a frame, and what presses on it.
struct PiledBall {
  Vec3 position = Vec3::Zero();
  double load = 0.0;  ///< half the sum of all impulses of a step, in impulses of its weight
};

struct Pile {
  std::vector<std::vector<PiledBall>> steps;
  double deepest = 0.0;         ///< overlap at the end of any step [m]
  double sinks = 0.0;           ///< at most, while two balls pass: see sinks()
  double deepest_at_end = 0.0;  ///< [m]
  double fastest_at_end = 0.0;  ///< [m/s]
  double carried = 0.0;         ///< by floor and cylinder in the last step, in weights of a ball
  std::size_t contacts = 0;     ///< in the last step
};

inline double deepest_overlap(const std::vector<NearContact>& contacts) {
  double deepest = 0.0;
  for (const NearContact& near : contacts) grow(deepest, -near.gap);
  return deepest;
}

/// By how far exact impulses let two balls sink into one another, at most: in a step they pass each
/// other along a straight line, and the sphere that their centres should keep to falls away from it
/// by (dt v)²/(2R), with R = 2 radii.
inline double sinks(const std::vector<RigidBody>& bodies,
                    const std::vector<NearContact>& contacts) {
  double fastest = 0.0;
  for (const NearContact& near : contacts) {
    if (near.contact.a == 0) continue;
    const auto velocity = [&](int k) { return bodies[static_cast<std::size_t>(k)].velocity; };
    grow(fastest, (velocity(near.contact.b) - velocity(near.contact.a)).norm());
  }
  return dt * dt * fastest * fastest / (4.0 * pile_radius);
}

/// Of the step that the impulses belong to.
inline void record(Pile& pile, const std::vector<RigidBody>& bodies,
                   const std::vector<NearContact>& contacts, const Vector& lambda) {
  std::vector<PiledBall> balls(bodies.size());
  pile.carried = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i].contact;
    const double share = lambda[static_cast<Eigen::Index>(i)] / (weight * dt);
    for (const int body : {contact.a, contact.b}) {
      balls[static_cast<std::size_t>(body)].load += 0.5 * share;
    }
    if (contact.a == 0) pile.carried += share * contact.normal.z();
  }
  grow(pile.sinks, sinks(bodies, contacts));
  pile.fastest_at_end = 0.0;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    balls[i].position = bodies[i].position;
    grow(pile.fastest_at_end, bodies[i].velocity.norm());
  }
  balls.erase(balls.begin());
  pile.steps.push_back(balls);
  pile.contacts = contacts.size();
}

/// v ← v + dt g + W Jᵀ λ with 0 ≤ λ ⊥ J v + φ/dt ≥ 0; then x ← x + dt v.
/// So no contact closes by more than its gap φ. What overlaps is moved out, but not faster than at
/// most_outwards, or a deep overlap would explode. λ starts from zero: what a few sweeps have left
/// undone would add up from step to step.
inline void step(Pile& pile, std::vector<RigidBody>& bodies) {
  for (RigidBody& body : bodies) {
    if (body.inverse_mass > 0.0) body.velocity += dt * gravity;
  }
  const std::vector<NearContact> near = near_contacts(bodies);
  pile.deepest_at_end = deepest_overlap(near);  // of the step before
  grow(pile.deepest, pile.deepest_at_end);
  std::vector<Contact> contacts(near.size());
  std::transform(near.begin(), near.end(), contacts.begin(),
                 [](const NearContact& one) { return one.contact; });
  const ContactSystem system = contact_system(bodies, contacts);
  Vector b = system.u;
  for (Eigen::Index i = 0; i < b.size(); ++i) {
    b[i] += std::max(near[static_cast<std::size_t>(i)].gap / dt, -most_outwards);
  }
  const Vector lambda = gauss_seidel(system.A, b, Vector::Zero(b.size()), sweeps);
  bodies = with_impulses(bodies, contacts, lambda);
  for (RigidBody& body : bodies) {
    if (!body.velocity.allFinite()) throw std::domain_error("velocities that are not finite");
    body.position += dt * body.velocity;
  }
  record(pile, bodies, near, lambda);
}

/// Balls that a wrong answer pulls into one another touch all others: then the pile stops.
inline constexpr std::size_t too_many = 1500;

/// Nothing, and an entry in `missing`, if a step of the lab is not written yet.
inline std::optional<Pile> piled(std::vector<std::string>& missing) {
  return common::if_written(missing, [] {
    Pile pile;
    std::mt19937 engine(7);
    std::vector<RigidBody> bodies{immovable()};  // with all obstacles; then balls, as they come
    for (int i = 0; i <= pile_duration * steps_a_second && pile.contacts < too_many; ++i) {
      pour(bodies, engine, i * dt);
      step(pile, bodies);
    }
    return pile;
  });
}

}  // namespace lab::multi_contact
