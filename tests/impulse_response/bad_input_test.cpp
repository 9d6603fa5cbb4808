#include <limits>

#include "bodies.hpp"
#include "catch.hpp"
#include "flight.hpp"

using namespace lab::impulse_response;
using tests::Trial;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
const Vec3 up = Vec3::UnitZ();
const Vec3 nan_vector(0.0, not_a_number, 0.0);
const Vec3 infinite_vector(infinite, 0.0, 0.0);

/// A number that must be refused, and what it is.
struct BadNumber {
  double value;
  const char* why;
};

std::vector<BadNumber> no_mass() {
  return {{0.0, "a mass must be above zero"},
          {-1.0, "a mass must be above zero"},
          {not_a_number, "the mass is NaN"},
          {infinite, "the mass is infinite"}};
}
std::vector<BadNumber> no_restitution() {
  return {{-0.01, "e must be from 0 to 1"},
          {1.01, "e must be from 0 to 1"},
          {not_a_number, "e is NaN"}};
}
std::vector<BadNumber> below_zero() {
  return {{-0.01, "it must not be below zero"},
          {not_a_number, "it is NaN"},
          {infinite, "it is infinite"}};
}
std::vector<Vec3> no_normals() {
  return {Vec3::Zero(), Vec3(0.0, 0.0, 1.0 + 3e-9), Vec3(0.0, 0.0, not_a_number), infinite_vector};
}

/// A call with one argument that is to be refused.
template <typename Call>
void refuse(const std::string& function, const std::vector<BadNumber>& numbers,
            const std::string& name, const Call& call) {
  for (const auto& [value, why] : numbers) {
    Trial(function).given(name, value).expect_throw([&, v = value] { return call(v); }, why);
  }
}
template <typename Call>
void refuse(const std::string& function, const std::vector<Vec3>& vectors, const std::string& name,
            const std::string& why, const Call& call) {
  for (const Vec3& value : vectors) {
    Trial(function).given(name, value).expect_throw([&] { return call(value); }, why);
  }
}

const char* const unit_normal = "a normal must have length one";
const char* const must_be_finite = "it is NaN or infinite";

/// Every input of a step that must be refused, given to `call`: the good one with one thing wrong.
template <typename Call>
void refuse_steps(const std::string& function, const tests::StepInput& good, const Call& call) {
  const auto refused = [&](const tests::StepInput& in, const std::string& why) {
    tests::step_trial(function, in).expect_throw([&] { return call(in); }, why);
  };
  const auto with = [&](const auto& change) {
    tests::StepInput in = good;
    change(in);
    return in;
  };
  for (const auto& [mass, why] : no_mass()) {
    refused(with([m = mass](auto& in) { in.particle.mass = m; }), why);
  }
  for (const auto& [e, why] : no_restitution()) {
    refused(with([r = e](auto& in) { in.material.restitution = r; }), why);
  }
  for (const double bad : {-0.01, not_a_number, infinite}) {
    refused(with([&](auto& in) { in.material.friction = bad; }),
            "mu must be finite and not below zero");
    refused(with([&](auto& in) { in.dt = bad; }), "dt must be finite and not below zero");
  }
  for (const Vec3& bad : {nan_vector, infinite_vector}) {
    refused(with([&](auto& in) { in.particle.position = bad; }), must_be_finite);
    refused(with([&](auto& in) { in.particle.velocity = bad; }), must_be_finite);
    refused(with([&](auto& in) { in.gravity = bad; }), must_be_finite);
    refused(with([&](auto& in) { in.obstacle = common::Plane{bad, up}; }), must_be_finite);
  }
  for (const Vec3& bad : no_normals()) {
    refused(with([&](auto& in) { in.obstacle = common::Plane{Vec3::Zero(), bad}; }), unit_normal);
  }
  for (const double bad : {0.0, -1.0, not_a_number, infinite}) {
    refused(with([&](auto& in) { in.obstacle = common::Cylinder{bad}; }),
            "a radius must be finite and above zero");
  }
}

/// What meets nothing in the step.
tests::StepInput in_flight() {
  tests::StepInput in;
  in.particle.position = up;
  in.particle.velocity = up;
  return in;
}

std::vector<RigidBody> no_bodies() {
  std::vector<RigidBody> bodies(10);
  bodies[0].inverse_mass = -1.0;
  bodies[1].inverse_mass = not_a_number;
  bodies[2].inverse_mass = infinite;
  bodies[3].position = nan_vector;
  bodies[4].velocity = infinite_vector;
  bodies[5].angular_velocity = nan_vector;
  bodies[6].inverse_inertia(1, 1) = not_a_number;
  bodies[7].inverse_inertia(0, 1) = 0.1;  // not symmetric
  bodies[8].inverse_inertia(2, 2) = -1.0;
  bodies[9].inverse_inertia *= 1e-6;
  bodies[9].inverse_inertia(0, 1) = 1e-10;  // 1e-4 of the largest entry
  return bodies;
}

const char* const body_why =
    "a body must be finite, and its inverse inertia symmetric without negative moments";

template <typename Call>
void refuse_bodies(const std::string& function, const Call& call) {
  for (const RigidBody& body : no_bodies()) {
    Trial(function)
        .given("body", tests::Code{tests::text_of(body)})
        .expect_throw([&] { return call(body); }, body_why);
  }
}

}  // namespace

// Each also where there is nothing to do: a shorter way must not lead past the checks.

TEST_CASE("A normal impulse of bad input is refused", "[6.1]") {
  const std::string f = "6.1 normal_impulse";
  for (const Vec3& v : {Vec3(-up), up}) {
    refuse(f, no_mass(), "mass", [&](double m) { return normal_impulse(m, v, up, 0.5); });
    refuse(f, no_restitution(), "restitution",
           [&](double e) { return normal_impulse(1.0, v, up, e); });
    refuse(f, no_normals(), "normal", unit_normal,
           [&](const Vec3& n) { return normal_impulse(1.0, v, n, 0.5); });
  }
  refuse(f, {nan_vector, infinite_vector}, "velocity", must_be_finite,
         [](const Vec3& v) { return normal_impulse(1.0, v, up, 0.5); });
}

TEST_CASE("Friction of bad input is refused", "[6.2]") {
  const std::string f = "6.2 friction_impulse";
  for (const Vec3& v : {Vec3(1.0, 0.0, -1.0), Vec3(-up)}) {
    refuse(f, below_zero(), "normal_impulse",
           [&](double j) { return friction_impulse(1.0, v, up, j, 0.5); });
    for (const double j : {1.0, 0.0}) {  // without pressure there is no friction to compute
      refuse(f, no_mass(), "mass", [&](double m) { return friction_impulse(m, v, up, j, 0.5); });
      refuse(f, below_zero(), "friction",
             [&](double mu) { return friction_impulse(1.0, v, up, j, mu); });
      refuse(f, no_normals(), "normal", unit_normal,
             [&](const Vec3& n) { return friction_impulse(1.0, v, n, j, 0.5); });
    }
  }
  for (const double j : {1.0, 0.0}) {
    refuse(f, {nan_vector, infinite_vector}, "velocity", must_be_finite,
           [&](const Vec3& u) { return friction_impulse(1.0, u, up, j, 0.5); });
  }
}

TEST_CASE("Corrections of bad input are refused", "[6.3]") {
  const std::string f = "6.3 normal_correction";
  const std::string g = "6.3 tangential_correction";
  refuse(f,
         {{not_a_number, must_be_finite}, {infinite, must_be_finite}, {-infinite, must_be_finite}},
         "gap", [](double gap) { return normal_correction(gap, up); });
  for (const double gap : {-1.0, 1.0}) {
    refuse(f, no_normals(), "normal", unit_normal,
           [&](const Vec3& n) { return normal_correction(gap, n); });
  }
  for (const Vec3& d : {Vec3(Vec3::UnitX()), Vec3(Vec3::Zero())}) {
    refuse(g, no_normals(), "normal", unit_normal,
           [&](const Vec3& n) { return tangential_correction(d, n, 1.0, 0.5); });
    refuse(g, below_zero(), "normal_length",
           [&](double length) { return tangential_correction(d, up, length, 0.5); });
    refuse(g, below_zero(), "friction",
           [&](double mu) { return tangential_correction(d, up, 1.0, mu); });
  }
  refuse(g, {nan_vector, infinite_vector}, "displacement", must_be_finite,
         [](const Vec3& d) { return tangential_correction(d, up, 1.0, 0.5); });
}

TEST_CASE("A step by projection of bad input is refused", "[6.4]") {
  for (const tests::StepInput& good : {tests::StepInput(), in_flight()}) {
    refuse_steps("step_by_projection", good,
                 [](const auto& in) { return tests::projected_by_answer(in).position; });
  }
}

TEST_CASE("A step to impact of bad input is refused", "[6.4]") {
  for (const tests::StepInput& good : {tests::StepInput(), in_flight()}) {
    refuse_steps("step_to_impact", good,
                 [](const auto& in) { return tests::impact_step_by_answer(in, 3).step.position; });
    for (const int max_impacts : {0, -1}) {
      tests::step_trial("step_to_impact", good)
          .given("max_impacts", max_impacts)
          .expect_throw(
              [&, most = max_impacts] {
                return tests::impact_step_by_answer(good, most).step.position;
              },
              "max_impacts must be at least 1");
    }
  }
}

TEST_CASE("Impossible bodies are refused", "[6.5]") {
  const RigidBody good;
  refuse_bodies("6.5 inverse_effective_mass",
                [&](const auto& bad) { return inverse_effective_mass(good, bad, up); });
  refuse_bodies("6.5 inverse_effective_mass",
                [&](const auto& bad) { return inverse_effective_mass(bad, good, up); });
  refuse_bodies("6.5 contact_impulse",
                [&](const auto& bad) { return contact_impulse(good, bad, {}, {}); });
  refuse_bodies("6.5 contact_impulse",
                [&](const auto& bad) { return contact_impulse(bad, good, {}, {}); });
  refuse_bodies("6.5 with_impulse",
                [&](const auto& bad) { return with_impulse(bad, up, up).velocity; });
}

TEST_CASE("Impossible contacts and impulses are refused", "[6.5]") {
  const RigidBody good;
  const std::string f = "6.5 contact_impulse";
  const std::vector<Vec3> bad_vectors{nan_vector, infinite_vector};
  refuse(f, no_normals(), "contact.normal", unit_normal, [&](const Vec3& n) {
    return contact_impulse(good, good, {Vec3::Zero(), n}, {});
  });
  refuse(f, bad_vectors, "contact.point", must_be_finite, [&](const Vec3& p) {
    return contact_impulse(good, good, {p, up}, {});
  });
  refuse(f, no_restitution(), "restitution", [&](double e) {
    return contact_impulse(good, good, {}, {e, 0.5});
  });
  refuse(f, below_zero(), "friction", [&](double mu) {
    return contact_impulse(good, good, {}, {0.5, mu});
  });
  refuse("6.5 inverse_effective_mass", bad_vectors, "point", must_be_finite,
         [&](const Vec3& p) { return inverse_effective_mass(good, good, p); });
  refuse("6.5 with_impulse", bad_vectors, "point", must_be_finite,
         [&](const Vec3& p) { return with_impulse(good, up, p).velocity; });
  refuse("6.5 with_impulse", bad_vectors, "impulse", must_be_finite,
         [&](const Vec3& j) { return with_impulse(good, j, up).velocity; });
}

TEST_CASE("Two bodies without a finite mass have no impulse", "[6.5]") {
  RigidBody pivoted = tests::ground();
  pivoted.inverse_inertia = Mat3::Identity();
  pivoted.velocity = -up;
  RigidBody beside = pivoted;  // it turns about a point beside the contact, so K is not zero
  beside.position = Vec3(1.0, 0.0, 0.0);
  beside.angular_velocity = Vec3(0.0, -1.0, 0.0);
  int index = 0;
  for (const RigidBody& a : {tests::ground(), pivoted}) {
    for (const RigidBody& b : {pivoted, beside}) {
      Trial("6.5 contact_impulse", ++index, 4)
          .given("a", tests::Code{tests::text_of(a)})
          .given("b", tests::Code{tests::text_of(b)})
          .expect_throw(
              [&, first = a, second = b] { return contact_impulse(first, second, {}, {}); },
              "both inverse masses are zero");
    }
  }
}
