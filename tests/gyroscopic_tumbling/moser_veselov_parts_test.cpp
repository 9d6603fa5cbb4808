#include "catch.hpp"
#include "moser_veselov_suspects.hpp"

using namespace lab::gyroscopic_tumbling;
using tests::as_vector;
using tests::corrected;
using tests::eps;
using tests::narrow;
using tests::QuatL;
using tests::Real;
using tests::Trial;
using tests::VecL;
using tests::wide;

namespace {

constexpr const char* increment = "2.8 moser_veselov_increment";

/// dt m_i from p, with the products' terms times `signs` and the whole times `factor`.
VecL momentum_of(const VecL& I, const QuatL& p, const VecL& signs, Real factor) {
  const VecL spread(I.z() - I.y(), I.x() - I.z(), I.y() - I.x());
  const VecL products(p.y() * p.z(), p.z() * p.x(), p.x() * p.y());
  return factor *
         (p.w() * tests::times(I, p.vec()) + tests::times(signs, tests::times(spread, products)));
}

/// What is left of the equation, in units of the momentum.
double residual(const Vec3& moments, const Vec3& momentum, double dt, const Quat& p,
                const VecL& signs = VecL::Ones(), Real factor = 2) {
  const VecL left = wide(dt) * wide(momentum);
  return static_cast<double>((momentum_of(wide(moments), wide(p), signs, factor) - left).norm() /
                             left.norm());
}

/// The same of b = p/p0 without the factor 1 + |b|², with the products or without.
double residual_of_b(const Vec3& moments, const Vec3& momentum, double dt, const Quat& p,
                     bool products) {
  const QuatL q = wide(p);
  const QuatL b(1, q.x() / q.w(), q.y() / q.w(), q.z() / q.w());
  const VecL left = wide(dt) * wide(momentum);
  const VecL signs = VecL::Constant(products ? 1 : 0);
  return static_cast<double>((momentum_of(wide(moments), b, signs, 2) - left).norm() / left.norm());
}

std::string likely_increment(const Vec3& moments, const Vec3& momentum, double dt, const Quat& p) {
  constexpr double fits = 1e-12;
  if (residual(moments, momentum, dt, p, -VecL::Ones()) < fits) {
    return "the sign of (I_k - I_j) p_j p_k is flipped, as in the equation at the end of the step: "
           "change it";
  }
  if (residual(moments, momentum, dt, p, VecL::Zero()) < fits)
    return "the term (I_k - I_j) p_j p_k is missing: add it";
  if (residual(moments, momentum, dt, p, VecL::Ones(), 1) < fits)
    return "the 2 of eq. (24) is missing, or the half of dt m if you divide by 2: put it in";
  for (int i = 0; i < 3; ++i) {
    VecL signs = VecL::Ones();
    signs(i) = -1;
    if (residual(moments, momentum, dt, p, signs) < fits) {
      return "one of the three differences I_k - I_j has the wrong sign: they are I3 - I2, I1 - "
             "I3, "
             "I2 - I1";
    }
  }
  if (residual(moments, -momentum, dt, p) < fits)
    return "p turns backwards: it has the sign of dt m";
  if (residual_of_b(moments, momentum, dt, p, true) < fits)
    return "the factor 1 + |b|^2 is missing: it stands beside dt m / 2";
  if (residual_of_b(moments, momentum, dt, p, false) < fits)
    return "this is the first b of the iteration: go on until b rests";
  const Quat unnormalised(1.0, p.x(), p.y(), p.z());
  if (std::abs(p.w() - 1.0) < fits &&
      residual(moments, momentum, dt, unnormalised.normalized()) < fits) {
    return "(1, b) is not normalised: divide it by its length";
  }
  return "";
}

/// Why there is no increment for m = 0 or dt = 0, if there is one for a small m.
std::string why_none_at_rest() {
  const auto exists = [](const Vec3& momentum) {
    try {
      moser_veselov_increment(Vec3(1.0, 2.0, 2.5), momentum, 1.0);
      return true;
    } catch (const std::domain_error&) {
      return false;
    }
  };
  return exists(Vec3(1e-3, 1e-3, 1e-3)) && !exists(Vec3::Zero())
             ? "b = 0 is right at once, but its change is not below a share of 0: stop by <="
             : "";
}

}  // namespace

std::string tests::likely_of_corrected_moments() {
  return likely_over<Vec3>(
      spin_cases(),
      [](const auto& in) {
        return corrected_moments(in.moments, {0.1 * in.dt, in.dt});
      },
      [](const auto& in) {
        return moment_suspects(in.moments, {0.1 * in.dt, in.dt});
      });
}

std::string tests::likely_of_correction() {
  return likely_over<Vec3>(
      spin_cases(),
      [](const auto& in) { return as_vector(fourth_order_correction(in.moments, in.spin, in.dt)); },
      [](const auto& in) { return correction_suspects(in.moments, in.spin, in.dt); });
}

TEST_CASE("Corrected moments have scaled and shifted inverses", "[2.8]") {
  tests::Random random(281);
  for (int i = 1; i <= 50; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const double scale = random.uniform(-0.2, 0.2);
    const double shift = random.uniform(-0.02, 0.02);
    const VecL I = wide(moments);
    tests::trial_of("2.8 corrected_moments", i, 50)
        .given("moments", moments)
        .given("correction.scale", scale)
        .given("correction.shift", shift)
        .expect(
            corrected_moments(moments, {scale, shift}),
            narrow(corrected(I, wide(scale), wide(shift))),
            {32.0 * eps * moments.norm(), "some 6 operations each, 1/I + shift above half of 1/I"},
            tests::moment_suspects(moments, {scale, shift}));
  }
}

TEST_CASE("A spin about an axis has an increment of the arc sine of theta", "[2.8]") {
  int index = 0;
  for (const int axis : {0, 1, 2}) {
    for (const double x : {1e-3, 0.5, 0.9, 0.99}) {
      const Vec3 moments(1.0, 2.0, 3.0);
      const Vec3 momentum = x * moments(axis) * Vec3::Unit(axis);
      const Trial trial = tests::trial_of(increment, ++index, 12)
                              .given("moments", moments)
                              .given("angular_momentum_body", momentum)
                              .given("dt", 1.0);
      const Quat p =
          trial.returned([&] { return moser_veselov_increment(moments, momentum, 1.0); });
      trial.expect(
          common::angle_between(Quat::Identity(), p), std::asin(x),
          {64.0 * eps / std::sqrt(1.0 - x * x), "the arc sine is steep towards theta = 1"},
          {{2.0 * std::atan(0.5 * x),
            "p0 is taken for 1, so p = dt omega / 2: use a p0 that makes p a unit quaternion"},
           {std::asin(0.5 * x), "the factor 2 is on the wrong side: see eq. (24)"}});
    }
  }
}

TEST_CASE("The increment solves its equation", "[2.8]") {
  tests::Random random(282);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Vec3 momentum = moments.cwiseProduct(random.vector(3.0));
    const double dt = random.uniform(0.01, 0.15);
    const Trial trial = tests::trial_of(increment, i, 100)
                            .given("moments", moments)
                            .given("angular_momentum_body", momentum)
                            .given("dt", dt);
    const Quat p = trial.returned([&] { return moser_veselov_increment(moments, momentum, dt); });
    trial.expect_small("residual of the equation, relative to dt m",
                       residual(moments, momentum, dt, p),
                       {256.0 * eps, "p to a few ulp, moments a factor 12 apart"},
                       likely_increment(moments, momentum, dt, p));
    trial.expect_small("||p| - 1|", std::abs(p.norm() - 1.0), {4.0 * eps, "normalised"},
                       "(1, b) is not normalised: divide it by its length");
    trial.expect_small("-p0", -p.w(), {0.0, "the solution whose p0 goes to 1 as dt goes to 0"});
  }
}

// dt m = 0 has the solution p = 1, where p_i Ĩ_i and all products are zero, without rounding.
TEST_CASE("At rest or for no time the increment is the identity", "[2.8]") {
  const Vec3 omega(0.3, -0.2, 0.1);
  const std::vector<std::pair<Vec3, double>> all{{Vec3::Zero(), 0.1},
                                                 {Vec3::Zero(), -1e60},
                                                 {omega, 0.0},
                                                 {1e60 * omega, 0.0},
                                                 {Vec3::Zero(), 0.0}};
  int index = 0;
  for (const auto& [velocity, dt] : all) {
    for (const Vec3& moments : {Vec3(1.0, 2.0, 2.5), Vec3(1e-50, 1e-50, 1e-50)}) {
      const Vec3 momentum = moments.cwiseProduct(velocity);
      const Trial trial = tests::trial_of(increment, ++index, 10)
                              .given("moments", moments)
                              .given("angular_momentum_body", momentum)
                              .given("dt", dt)
                              .suspecting(why_none_at_rest);
      const Quat p =
          trial.returned([&, &h = dt] { return moser_veselov_increment(moments, momentum, h); });
      trial.expect(p, Quat::Identity(), {4.0 * eps, "a division of 1 by a root of 1"});
    }
  }
}

TEST_CASE("An increment exists at 0.9 of the limit and none at 1.1", "[2.8]") {
  const Vec3 moments(1.0, 2.0, 3.0);
  for (const int axis : {0, 1, 2}) {
    const Vec3 limit = moments(axis) * Vec3::Unit(axis);  // |m| dt = I at dt = 1
    const Trial trial =
        tests::trial_of(increment, axis + 1, 3).given("angular_momentum_body", limit);
    const Quat p =
        trial.returned([&] { return moser_veselov_increment(moments, 0.9 * limit, 1.0); });
    trial.of("0.9 of the limit")
        .expect_small("residual of the equation, relative to dt m",
                      residual(moments, 0.9 * limit, 1.0, p), {256.0 * eps, "a solution exists"},
                      likely_increment(moments, 0.9 * limit, 1.0, p));
    trial.of("1.1 of the limit")
        .expect_throw<std::domain_error>(
            [&] { return moser_veselov_increment(moments, 1.1 * limit, 1.0); },
            "sin of the angle would be 1.1");
    for (const double share : {1e-3, 1e-6, 1e-9, 1e-12}) {
      tests::trial_of(increment, axis + 1, 3)
          .given("angular_momentum_body", Vec3((1.0 + share) * limit))
          .expect_throw<std::domain_error>(
              [&] { return moser_veselov_increment(moments, (1.0 + share) * limit, 1.0); },
              "sin of the angle would be above 1, by far more than rounding",
              "an approximate solution is returned: throw if there is no exact one");
    }
  }
}

TEST_CASE("The correction of order four is made of energy and angular momentum", "[2.8]") {
  tests::Random random(285);
  for (int i = 1; i <= 100; ++i) {
    const Vec3 moments = tests::random_moments(random);
    const Spin spin = tests::random_spin(random);
    const double dt = random.uniform(-0.2, 0.2);
    const MomentCorrection wanted = tests::with_powers(moments, spin, dt);
    const Vec3 without_dt = as_vector(wanted) / (dt * dt);
    tests::spin_trial("2.8 fourth_order_correction", moments, spin, i, 100)
        .given("dt", dt)
        .of("(scale, shift)")
        .expect(as_vector(fourth_order_correction(moments, spin, dt)), as_vector(wanted),
                {256.0 * eps * without_dt.norm() * dt * dt + 1e-15,
                 "some 20 operations; the two terms cancel to a tenth at most"},
                tests::correction_suspects(moments, spin, dt));
  }
}
