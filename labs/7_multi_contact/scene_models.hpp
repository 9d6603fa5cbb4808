#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "touching_balls.hpp"

/// The models that the scene shows beside one another, and what their impacts keep.
namespace lab::multi_contact {

/// A model of what happens where many contacts meet at once, for e = 1.
struct Model {
  std::array<const char*, 2> name;  ///< in two lines
  const char* what;                 ///< it counts
  Impulses (*impulses)(const ContactSystem&);
};

inline constexpr int cap = 1000;  // of impulses or reflections

inline const std::array<Model, 3> models{
    {{{"one after", "the other"},
      "impulses",
      [](const ContactSystem& system) { return sequential_impulses(system, 1.0, cap); }},
     {{"all", "at once"},
      "solve",
      [](const ContactSystem& system) {
        return Impulses{simultaneous_impulses(system, 1.0), 1, true};
      }},
     {{"generalized", "reflections"}, "reflections", [](const ContactSystem& system) {
        return generalized_reflections(system, 1.0, cap);
      }}}};

/// What the impacts of a motion did, and by how much they broke what they should have kept.
struct Ledger {
  int first_count = 0;          ///< of impulses or reflections, at the first impact
  double momentum_error = 0.0;  ///< largest |Δp| as a share of Σ m |v|
  double energy_error = 0.0;    ///< largest |ΔE| as a share of E
  int impacts = 0;
};

/// The last of the parts of a motion that has started by then; the first if none has.
template <typename Part>
const Part& part_at(const std::vector<Part>& parts, double time) {
  std::size_t i = 0;
  while (i + 1 < parts.size() && parts[i + 1].start <= time) ++i;
  return parts[i];
}

/// As std::max, but what is not a number stays.
inline void grow(double& largest, double value) {
  largest = std::isnan(value) ? value : std::max(largest, value);
}

inline double energy(const std::vector<RigidBody>& bodies) {
  double sum = 0.0;
  for (const RigidBody& body : bodies) sum += 0.5 * body.velocity.squaredNorm();
  return sum;
}

/// The bodies after an impact at the contacts that touch, which goes into the ledger.
inline std::vector<RigidBody> after_impact(const Model& model, const std::vector<RigidBody>& bodies,
                                           double radius, Ledger& ledger) {
  constexpr double touching = 1e-9;  // [m], well above the rounding of positions
  std::vector<Contact> contacts;
  for (const NearContact& near : near_balls(bodies, 0, radius, touching)) {
    contacts.push_back(near.contact);
  }
  const Impulses impulses = model.impulses(contact_system(bodies, contacts));
  std::vector<RigidBody> after = with_impulses(bodies, contacts, impulses.lambda);

  Vec3 gained = Vec3::Zero();
  double all = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!after[i].velocity.allFinite()) throw std::domain_error("velocities that are not finite");
    gained += after[i].velocity - bodies[i].velocity;
    all += bodies[i].velocity.norm();
  }
  grow(ledger.momentum_error, gained.norm() / all);
  grow(ledger.energy_error, std::abs(energy(after) / energy(bodies) - 1.0));
  if (ledger.impacts++ == 0) ledger.first_count = impulses.count;
  return after;
}

}  // namespace lab::multi_contact
