// What students get wrong in step 7.4.
#include "fingerprint.hpp"
#include "judged.hpp"

namespace tests {
namespace {

struct AtOnceInput {
  ContactSystem system;
  double restitution = 1.0;
};

/// A row in which one neighbour parts, a rod that one end would have to pull, a ball between two
/// walls, and what approaches slowly.
std::vector<AtOnceInput> at_once_inputs() {
  return {{row_of_balls(Vector{{1.0, 2.0, 1.0}}, Vector{{1.0, 0.0, 0.25}}).system(), 0.5},
          {cradle(Vector{{1.0, 0.5, -1.0, 0.0}}).system(), 0.25},
          {dumb_bell().system(), 0.5},
          {cradle(Vector{{1.0, 0.0, 2.0}}).system(), 0.5},
          {{Matrix{{2.0}}, Vector{{1.0}}}, 0.5},
          {{Matrix{{1.0, 0.0}, {0.0, 2.0}}, Vector{{-1.0, -0x1p-20}}}, 0.5}};
}

using Wrong = Mistake<AtOnceInput, Vector>;

/// The exact solution of another b.
template <typename OtherB>
Wrong solves(const std::string& story, const OtherB& other_b) {
  return {story, [other_b](const AtOnceInput& in, const Vector& got) {
            const Vector b = other_b(in.system.u, in.restitution);
            const auto wrong = exact_solution(in.system.A, b);
            return wrong && near(got, wrong->lambda);
          }};
}

/// All contacts as equations; `clamped` where what pulls is set to zero afterwards.
Wrong solves_equations(const std::string& story, bool clamped) {
  return {story, [clamped](const AtOnceInput& in, const Vector& got) {
            const Vector& u = in.system.u;
            const Vector b = u + in.restitution * u.cwiseMin(0.0);
            Vector lambda = common::least_norm_solution(in.system.A, -b);
            if (clamped) lambda = lambda.cwiseMax(0.0);
            return near(got, lambda);
          }};
}

Vector poisson(const ContactSystem& system, double e) {
  const auto first = exact_solution(system.A, system.u);
  if (!first) return {};
  const Vector lambda = (1.0 + e) * first->lambda;
  const auto more = exact_solution(system.A, exact_row_sums(system.A, lambda, system.u));
  return more ? Vector(lambda + more->lambda) : Vector();
}

}  // namespace

std::string likely_of_simultaneous_impulses() {
  std::vector<Wrong> all{
      solves("e is missing: b_i = u_i + e min(u_i, 0)", [](const Vector& u, double) { return u; }),
      solves("what parts is asked for a bounce, too: (1 + e) belongs to u_i below zero alone",
             [](const Vector& u, double e) { return Vector((1.0 + e) * u); }),
      solves("e counts twice: b_i = u_i + e min(u_i, 0)",
             [](const Vector& u, double e) { return Vector(u + 2.0 * e * u.cwiseMin(0.0)); }),
      solves(
          "e stands where 1 + e belongs: stop the contact first, then let it bounce",
          [](const Vector& u, double e) { return Vector(e * u.cwiseMin(0.0) + u.cwiseMax(0.0)); }),
      solves("u_i is missing, only its bounce is asked for: b_i = u_i + e min(u_i, 0)",
             [](const Vector& u, double e) { return Vector(e * u.cwiseMin(0.0)); }),
      solves("what parts is slowed down: b_i = u_i where u_i is above zero",
             [](const Vector& u, double e) { return Vector(u - e * u.cwiseAbs()); }),
      solves("the bounce has the wrong sign: b_i = u_i + e min(u_i, 0)",
             [](const Vector& u, double e) { return Vector(u - e * u.cwiseMin(0.0)); }),
      solves("max stands where min belongs: what approaches is asked for a bounce",
             [](const Vector& u, double e) { return Vector(u + e * u.cwiseMax(0.0)); }),
      solves("every contact bounces elastically: e is not used",
             [](const Vector& u, double) { return Vector(u + u.cwiseMin(0.0)); }),
      solves("contacts that part are forgotten: they count with u_i, the others can close them",
             [](const Vector& u, double e) { return Vector((1.0 + e) * u.cwiseMin(0.0)); }),
      solves_equations("A lambda = -b is solved, so contacts pull: use common::complementary",
                       false),
      solves_equations("A lambda = -b is solved and clamped: use common::complementary", true)};
  all.push_back(
      {"the impulses without bounce are enlarged by 1 + e, and what then approaches is "
       "stopped (Poisson): solve once, with the bounce in b",
       [](const AtOnceInput& in, const Vector& got) {
         return near(got, poisson(in.system, in.restitution));
       }});
  return fingerprint(
      at_once_inputs(),
      [](const AtOnceInput& in) {
        return lab::multi_contact::simultaneous_impulses(in.system, in.restitution);
      },
      all);
}

}  // namespace tests
