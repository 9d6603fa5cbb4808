// What students get wrong in step 7.1.
#include "bodies.hpp"
#include "fingerprint.hpp"

namespace tests {
namespace {

using common::Mat3;
using common::Vec3;

RigidBody body(double inverse_mass, const Vec3& diagonal, const Vec3& position,
               const Vec3& velocity, const Vec3& spin) {
  RigidBody result{inverse_mass, diagonal.asDiagonal(), position, velocity, spin};
  result.inverse_inertia(0, 1) = result.inverse_inertia(1, 0) = 0.125 * diagonal.minCoeff();
  return result;
}

/// Three bodies that touch, one pair of them twice, and one of them in both roles.
Bodies touching() {
  Bodies all;
  all.bodies = {
      body(0.5, {1.0, 2.0, 0.5}, {-0.5, 0.25, 0.5}, {1.0, 0.5, 1.5}, {0.5, -1.0, 0.25}),
      body(2.0, {1.5, 0.5, 1.0}, {0.5, -0.25, 2.0}, {-1.5, 0.25, -2.0}, {0.25, 1.0, -0.5}),
      body(0.25, {0.5, 0.25, 2.0}, {2.0, 1.0, 1.0}, {0.5, -1.0, 0.25}, {1.0, 0.5, 0.75})};
  all.contacts = {{0, 1, {0.25, 0.5, 1.25}, {0.0, 0.6, 0.8}},
                  {1, 2, {1.5, 0.25, 1.5}, {0.8, 0.0, -0.6}},
                  {0, 1, {-0.25, 0.5, 1.0}, {0.6, 0.0, 0.8}}};
  return all;
}

/// The rod on its supports, one of which is named the other way round.
std::vector<Bodies> system_inputs() {
  Bodies rod = rod_as_bodies(0.25, -1.0, 0.5);
  Contact& turned = rod.contacts.back();
  turned = {turned.b, turned.a, turned.point, -turned.normal};
  return {touching(), rod,
          row_of_balls_as_bodies(Vector{{1.0, 2.0, 4.0}}, Vector{{1.0, 0.0, 0.5}})};
}

bool alike(const ContactSystem& got, const ContactSystem& wanted) {
  return near(got.A, wanted.A) && near(got.u, wanted.u);
}

struct BodiesInput {
  Bodies bodies;
  Vector lambda;
};

struct EnergyInput {
  ContactSystem system;
  Vector lambda;
};

std::vector<Mistake<EnergyInput, double>> energy_mistakes() {
  using In = EnergyInput;
  const auto work = [](const In& in) { return in.lambda.dot(in.system.u); };
  const auto own = [](const In& in) {
    return in.lambda.dot(common::product(in.system.A, in.lambda));
  };
  return {returns<In, double>("the half is missing: the speed in the mean is u + A lambda/2",
                              [=](const In& in) { return work(in) + own(in); }),
          returns<In, double>(
              "u is that before the impulses: the speed in the mean is u + A lambda/2", work),
          returns<In, double>("all of it is halved: only A lambda is",
                              [=](const In& in) { return 0.5 * (work(in) + own(in)); }),
          returns<In, double>("A lambda has the wrong sign: impulses add to u",
                              [=](const In& in) { return work(in) - 0.5 * own(in); }),
          returns<In, double>("it has the wrong sign: what is lost is below zero",
                              [=](const In& in) { return -work(in) - 0.5 * own(in); }),
          returns<In, double>("u is missing: the speed in the mean is u + A lambda/2",
                              [=](const In& in) { return 0.5 * own(in); })};
}

}  // namespace

std::string likely_of_contact_system() {
  std::vector<Mistake<Bodies, ContactSystem>> all;
  for (const auto& [flaw, story] : system_flaws()) {
    all.push_back({story, [f = flaw](const Bodies& in, const ContactSystem& got) {
                     return alike(got, system_of(in, f));
                   }});
  }
  return fingerprint(
      system_inputs(),
      [](const Bodies& in) { return lab::multi_contact::contact_system(in.bodies, in.contacts); },
      all);
}

std::string likely_of_with_impulses() {
  using Result = std::vector<RigidBody>;
  std::vector<Mistake<BodiesInput, Result>> all;
  for (const auto& [flaw, story] : impulse_flaws()) {
    all.push_back({story, [f = flaw](const BodiesInput& in, const Result& got) {
                     const Result wrong = bodies_after(in.bodies, in.lambda, f);
                     if (got.size() != wrong.size()) return false;
                     for (std::size_t k = 0; k < wrong.size(); ++k) {
                       if (!near(got[k].velocity, wrong[k].velocity) ||
                           !near(got[k].angular_velocity, wrong[k].angular_velocity)) {
                         return false;
                       }
                     }
                     return true;
                   }});
  }
  return fingerprint(
      std::vector<BodiesInput>{{touching(), Vector{{1.0, 2.0, -0.5}}}},
      [](const BodiesInput& in) {
        return lab::multi_contact::with_impulses(in.bodies.bodies, in.bodies.contacts, in.lambda);
      },
      all);
}

std::string likely_of_energy_gained() {
  return fingerprint(
      std::vector<EnergyInput>{
          {{Matrix{{2.0, -1.0}, {-1.0, 3.0}}, Vector{{-1.0, 0.25}}}, Vector{{2.0, 0.5}}},
          {{Matrix{{2.0}}, Vector{{1.0}}}, Vector{{3.0}}}},
      [](const EnergyInput& in) { return lab::multi_contact::energy_gained(in.system, in.lambda); },
      energy_mistakes());
}

}  // namespace tests
