#include <limits>
#include <stdexcept>

#include "catch.hpp"
#include "momentum_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::eps;
using tests::narrow;
using tests::Real;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* accelerate = "2.1 angular_acceleration";

void expect_acceleration(const Trial& trial, const Mat3& inertia, const Vec3& omega,
                         const Vec3& torque) {
  const tests::MatL I = inertia.cast<Real>();
  const VecL w = wide(omega);
  const Vec3 wanted = narrow(I.inverse() * (wide(torque) - w.cross(VecL(I * w))));
  const double condition = inertia.norm() * inertia.inverse().norm();
  const double terms = torque.norm() + omega.norm() * (inertia * omega).norm();
  Trial(trial)
      .given("inertia", inertia)
      .given("angular_velocity", omega)
      .given("torque", torque)
      .expect(angular_acceleration(inertia, omega, torque), wanted,
              {32.0 * eps * condition * inertia.inverse().norm() * terms,
               "some 30 operations; the condition of the inertia multiplies their roundings"},
              tests::acceleration_suspects(inertia, omega, torque));
}

/// A flat body's moments, the greatest an ulp above the sum of the others.
Vec3 ulp_over(double size) {
  return {0.1 * size, 0.2 * size, std::nextafter(0.1 * size + 0.2 * size, HUGE_VAL)};
}

/// Why a moment that is above the sum of the others passes.
std::string why_accepted(const Vec3& moments) {
  int greatest = 0;
  moments.maxCoeff(&greatest);
  Vec3 impossible = Vec3::Ones();
  impossible(greatest) = 3.0;
  const auto accepted = [](const Vec3& wrong) {
    try {
      checked_moments(wrong);
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  };
  if (!accepted(impossible)) {
    return "the tolerance of the triangle inequality is too wide: allow a few 1e-16 of the "
           "greatest moment";
  }
  if (!accepted({3.0, 1.0, 1.0}) || !accepted({1.0, 3.0, 1.0}) || !accepted({1.0, 1.0, 3.0})) {
    return "the triangle inequality is checked for some moments only: check it for all three";
  }
  return "the triangle inequality is not checked: throw if a moment is above the sum of the others";
}

Spin quarter_turned(const Vec3& angular_velocity_body) {
  return {Quat(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)), angular_velocity_body};
}

}  // namespace

namespace tests {
namespace {

struct AccelerationInput {
  Mat3 inertia;
  Vec3 omega, torque;
};

std::vector<std::pair<Vec3, Spin>> spins() {
  Random random(217);
  std::vector<std::pair<Vec3, Spin>> all;
  for (int i = 0; i < 10; ++i) {
    const Vec3 moments = random_moments(random);
    all.emplace_back(moments, random_spin(random));
  }
  return all;
}

}  // namespace

std::string likely_of_acceleration() {
  Random random(218);
  std::vector<AccelerationInput> inputs;
  for (int i = 0; i < 10; ++i) {
    const Mat3 inertia = random.inertia();
    inputs.push_back({inertia, random.vector(5.0), random.vector(5.0)});
  }
  return likely_over<Vec3>(
      inputs, [](const auto& in) { return angular_acceleration(in.inertia, in.omega, in.torque); },
      [](const auto& in) { return acceleration_suspects(in.inertia, in.omega, in.torque); });
}

std::string likely_of_energy() {
  return likely_over<double>(
      spins(), [](const auto& in) { return rotational_energy(in.first, in.second); },
      [](const auto& in) { return energy_suspects(in.first, in.second); });
}

std::string likely_of_momentum() {
  return likely_over<Vec3>(
      spins(), [](const auto& in) { return angular_momentum(in.first, in.second); },
      [](const auto& in) { return momentum_suspects(in.first, in.second); });
}

}  // namespace tests

TEST_CASE("Without a torque omega 1 1 1 on moments 1 2 3 accelerates by the cross product",
          "[2.1]") {
  // omega x I omega = (1, 1, 1) x (1, 2, 3) = (1, -2, 1), divided by the moments, with a minus.
  const Mat3 inertia = Vec3(1.0, 2.0, 3.0).asDiagonal();
  const Vec3 omega(1.0, 1.0, 1.0);
  tests::trial_of(accelerate)
      .given("inertia", inertia)
      .given("angular_velocity", omega)
      .given("torque", Vec3(Vec3::Zero()))
      .expect(angular_acceleration(inertia, omega, Vec3::Zero()), Vec3(-1.0, 1.0, -1.0 / 3.0),
              {8.0 * eps, "a few roundings of numbers near one"},
              tests::acceleration_suspects(inertia, omega, Vec3::Zero()));
}

TEST_CASE("The acceleration follows from inertia and torque for bodies in any pose", "[2.1]") {
  tests::Random random(211);
  for (int i = 1; i <= 100; ++i) {
    expect_acceleration(tests::trial_of(accelerate, i, 100), random.inertia(), random.vector(5.0),
                        random.vector(5.0));
  }
}

TEST_CASE("A torque on a body at rest turns it through the inverse of its inertia", "[2.1]") {
  tests::Random random(212);
  for (int i = 1; i <= 20; ++i) {
    expect_acceleration(tests::trial_of(accelerate, i, 20), random.inertia(), Vec3::Zero(),
                        random.vector(2.0));
  }
}

TEST_CASE("In turned axes the acceleration is the same vector turned", "[2.1]") {
  tests::Random random(213);
  for (int i = 1; i <= 50; ++i) {
    const Mat3 inertia = random.inertia();
    const Vec3 omega = random.vector(3.0);
    const Vec3 torque = random.vector(3.0);
    const Mat3 R = random.attitude().toRotationMatrix();
    const Vec3 turned_inputs =
        angular_acceleration(R * inertia * R.transpose(), R * omega, R * torque);
    const Vec3 turned_result = R * angular_acceleration(inertia, omega, torque);
    const double scale =
        inertia.inverse().norm() * (torque.norm() + omega.norm() * (inertia * omega).norm());
    tests::trial_of(accelerate, i, 50)
        .given("inertia", inertia)
        .given("angular_velocity", omega)
        .given("torque", torque)
        .expect(turned_inputs, turned_result,
                {128.0 * eps * inertia.norm() * inertia.inverse().norm() * scale,
                 "both sides round some 60 times, multiplied by the condition of the inertia"});
  }
}

TEST_CASE("Omega 1 2 3 on moments 1 2 3 has an energy of 18", "[2.1]") {
  const Vec3 moments(1.0, 2.0, 3.0);
  tests::Random random(214);
  for (int i = 1; i <= 10; ++i) {
    const Spin spin{random.attitude(), Vec3(1.0, 2.0, 3.0)};
    tests::spin_trial("2.1 rotational_energy", moments, spin, i, 10)
        .expect(rotational_energy(moments, spin), 18.0,
                {128.0 * eps * 18.0, "some 60 operations if it is computed in the world frame"},
                tests::energy_suspects(moments, spin));
  }
}

TEST_CASE("The energy is half of omega times angular momentum whatever the attitude", "[2.1]") {
  tests::Random random(215);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random);
    const Vec3& omega = spin.angular_velocity_body;
    const double wanted =
        static_cast<double>(wide(omega).dot(tests::times(wide(moments), wide(omega))) / 2);
    tests::spin_trial("2.1 rotational_energy", moments, spin, i, 100)
        .expect(rotational_energy(moments, spin), wanted,
                {512.0 * eps * wanted,
                 "some 60 operations if it is computed in the world frame, with moments a factor 4 "
                 "apart"},
                tests::energy_suspects(moments, spin));
  }
}

TEST_CASE("A quarter turn about z takes the momentum 1 2 3 to minus 2 1 3", "[2.1]") {
  const Vec3 moments(1.0, 2.0, 3.0);
  const Spin spin = quarter_turned(Vec3(1.0, 1.0, 1.0));
  tests::spin_trial("2.1 angular_momentum", moments, spin)
      .expect(angular_momentum(moments, spin), Vec3(-2.0, 1.0, 3.0),
              {32.0 * eps, "some 20 operations on numbers up to 3"},
              tests::momentum_suspects(moments, spin));
}

TEST_CASE("The angular momentum is that of the body turned into the world", "[2.1]") {
  tests::Random random(216);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random);
    const VecL m = tests::times(wide(moments), wide(spin.angular_velocity_body));
    const tests::QuatL q = wide(spin.world_from_body).normalized();
    tests::spin_trial("2.1 angular_momentum", moments, spin, i, 100)
        .expect(angular_momentum(moments, spin), narrow(q * m),
                {32.0 * eps * static_cast<double>(m.norm()),
                 "a turn of some 20 operations by a quaternion that is unit to rounding"},
                tests::momentum_suspects(moments, spin));
  }
}

TEST_CASE("Moments that a body can have are returned as they are", "[2.1]") {
  const std::vector<Vec3> good{{1.0, 2.0, 2.5}, {1.0, 1.0, 1.0},       {0.3, 0.4, 0.7},
                               {3.0, 2.0, 1.0}, {1e-20, 1e-20, 1e-20}, {0.1, 0.2, 0.1 + 0.2},
                               {5.0, 2.0, 3.0}, {1e-9, 1.0, 1.0},      ulp_over(1e6),
                               ulp_over(1e-6),  ulp_over(1e-58),       ulp_over(1e58)};
  int index = 0;
  for (const Vec3& moments : good) {
    const Trial trial =
        tests::trial_of("2.1 checked_moments", ++index, static_cast<int>(good.size()))
            .given("moments", moments);
    Vec3 got = Vec3::Zero();
    try {
      got = checked_moments(moments);
    } catch (const std::invalid_argument&) {
      const bool flat = moments.maxCoeff() >= 0.499999 * moments.sum();
      trial.expect_small("1 if the moments are refused", 1.0, {0.0, "a body can have them"},
                         flat ? "a flat body is refused: its greatest moment may equal the sum of "
                                "the others, up to rounding"
                              : "");
    }
    trial.expect(got, moments, {0.0, "nothing is computed"});
  }
}

TEST_CASE("Moments that no body can have are refused", "[2.1]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const char* const positive = "each moment must be above zero";
  const char* const finite = "each moment must be finite";
  const char* const triangle = "no moment may be above the sum of the others, at any size";
  struct Bad {
    Vec3 moments;
    const char* why;
  };
  std::vector<Bad> all{{{1.0, 0.0, 1.0}, positive},         {{1.0, 1.0, -1.0}, positive},
                       {{-1.0, -1.0, -1.0}, positive},      {{1.0, nan, 1.0}, finite},
                       {{infinity, infinity, 1.0}, finite}, {{1.0, 2.0, 3.1}, triangle},
                       {{1.0, 2.0 + 1e-9, 1.0}, triangle},  {{2.0 + 2e-12, 1.0, 1.0}, triangle},
                       {{1.0, 1.0, 2.0 + 6e-14}, triangle}, {{1e-9, 1e-9, 3e-9}, triangle},
                       {{7.0, 1.0, 1.0}, triangle}};
  // The contract's range is 1e-60 to 1e60. Powers of two round nothing, so the excess stays 3e-14
  // of the greatest moment or more.
  for (const double size : {0x1p-190, 0x1p-133, 0x1p-53, 0x1p17, 0x1p133, 0x1p190}) {
    for (const Vec3& one :
         {Vec3(3.0, 1.0, 1.0), Vec3(1.0, 2.0 + 1e-9, 1.0), Vec3(1.0, 1.0, 2.0 + 6e-14)}) {
      all.push_back({size * one, triangle});
    }
  }
  int index = 0;
  for (const Bad& bad : all) {
    const Trial trial =
        tests::trial_of("2.1 checked_moments", ++index, static_cast<int>(all.size()))
            .given("moments", bad.moments)
            .suspecting([&]() -> std::string {
              if (bad.why == triangle) return why_accepted(bad.moments);
              return bad.why == positive
                         ? "the sign is not checked: throw if a moment is not above zero"
                         : "NaN and infinity are not checked: throw if a moment is not finite";
            });
    trial.expect_throw([&] { return checked_moments(bad.moments); }, bad.why);
  }
}
