// What students get wrong in steps 6.1 to 6.3.
#include "fingerprint.hpp"
#include "likely.hpp"
#include "particle_cases.hpp"

namespace tests {
namespace {

using common::Vec3;
constexpr double tiny = 1e-50;  // what any threshold takes for none

const Vec3 up = Vec3::UnitZ();
const Vec3 oblique(0.0, 0.6, -0.8);

std::vector<NormalCase> normal_inputs() {
  return {{3.0, {4.0, 5.0, -2.0}, up, 0.5},    {2.0, {1.0, -3.0, 4.0}, oblique, 0.25},
          {0.5, {-1.0, 2.0, 3.0}, up, 0.75},   {2.0, {1.0, 2.0, -3.0}, oblique, 0.125},
          {2.0, {0.0, 0.0, -1e-100}, up, 0.5}, {2.0, {0.0, 0.0, 1e-100}, up, 0.5}};
}

double speed_of(const NormalCase& c) { return static_cast<double>(normal_speed(c)); }

/// The right impulse, times `share` of the approach.
auto share_of_approach(double (*share)(const NormalCase&)) {
  return [share](const NormalCase& c) { return speed_of(c) < 0.0 ? share(c) * -speed_of(c) : 0.0; };
}

Mistake<NormalCase, double> at_tiny_speeds(const std::string& story, double sign,
                                           double (*value)(const NormalCase&)) {
  return {story, [=](const NormalCase& c, double got) {
            const double v_n = speed_of(c) * sign;
            return near(got, v_n > 0.0 && v_n < tiny ? value(c) : exact_normal(c));
          }};
}

double parting_impulse(const NormalCase& c) {
  return -(1.0 + c.restitution) * c.mass * speed_of(c);
}

std::vector<Mistake<NormalCase, double>> normal_mistakes() {
  using C = NormalCase;
  const auto of = [](const std::string& story, const auto& value) {
    return returns<C, double>(story, value);
  };
  const std::string parts = "a particle that moves away gets an impulse: return 0 if v_n >= 0";
  return {of("the normal is taken the other way round: use v_n = n.v without a minus sign",
             [](const C& c) { return std::max(0.0, -parting_impulse(c)); }),
          of("there is no impulse at all: return -(1 + e) m v_n if v_n < 0",
             [](const C&) { return 0.0; }),
          of(parts, parting_impulse),
          of(parts, [](const C& c) { return std::abs(parting_impulse(c)); }),
          of("e is used instead of 1 + e",
             share_of_approach([](const C& c) { return c.restitution * c.mass; })),
          of("1 - e is used instead of 1 + e",
             share_of_approach([](const C& c) { return (1.0 - c.restitution) * c.mass; })),
          of("the impulse is missing the mass: multiply by m",
             share_of_approach([](const C& c) { return 1.0 + c.restitution; })),
          of("the speed is divided by the mass: multiply by m",
             share_of_approach([](const C& c) { return (1.0 + c.restitution) / c.mass; })),
          of("restitution is missing: multiply by 1 + e",
             share_of_approach([](const C& c) { return c.mass; })),
          of("the impulse points inwards: change its sign",
             share_of_approach([](const C& c) { return -(1.0 + c.restitution) * c.mass; })),
          of("the whole speed is used: use only its normal part v_n",
             [](const C& c) {
               return speed_of(c) < 0.0 ? (1.0 + c.restitution) * c.mass * c.velocity.norm() : 0.0;
             }),
          at_tiny_speeds("a small speed is taken for zero: test only for exactly zero", -1.0,
                         [](const C&) { return 0.0; }),
          at_tiny_speeds(
              "a particle that moves away slowly gets an impulse: compare v_n with exactly zero",
              1.0, parting_impulse)};
}

/// Of (2) and of (4), which is (2) of a displacement for a mass of one.
struct SlipWords {
  std::string along, no_limit, always_limit, no_mu, whole, whole_length, over_whole, not_unit, none,
      small, padded, nan;
};

/// A rule of slip: mass, slip, whole motion and the limits with and without mu.
struct SlipParts {
  Real mass;
  VecL slip;
  VecL whole;
  Real cone;
  Real pressed;
};

SlipParts parts(const FrictionCase& c) {
  return {wide(c.mass), slip(c), wide(c.velocity), cone(c), wide(c.normal_impulse)};
}
SlipParts parts(const CorrectionCase& c) {
  return {1, slip(c), wide(c.displacement), cone(c), wide(c.normal_length)};
}

Vec3 right_of(const SlipParts& p) { return narrow(braked(p.mass * p.slip, p.cone)); }

/// −size along v; zero where v is.
Vec3 along(Real size, const VecL& v) {
  return narrow(v.norm() == 0 ? VecL(VecL::Zero()) : VecL(-size / v.norm() * v));
}

/// Right but where there is hardly a slip. By its share of the right length there it is known.
template <typename Input>
Mistake<Input, Vec3> at_tiny_slips(const std::string& story, bool (*is_share)(double)) {
  return {story, [=](const Input& c, const Vec3& got) {
            const SlipParts p = parts(c);
            const bool is_tiny = p.slip.norm() > 0 && p.slip.norm() < wide(tiny);
            if (!is_tiny) return near(got, right_of(p), 1e-4);
            return is_share(length(got) / length(right_of(p)));
          }};
}

template <typename Input>
std::vector<Mistake<Input, Vec3>> slip_mistakes(const SlipWords& words) {
  const auto of = [](const std::string& story, Vec3 (*value)(const SlipParts&)) {
    return Mistake<Input, Vec3>{story, [value](const Input& c, const Vec3& got) {
                                  const SlipParts p = parts(c);
                                  const bool divides_by_zero =
                                      p.slip.norm() == 0 && !is_finite(got);
                                  return divides_by_zero || near(got, value(p));
                                }};
  };
  using P = SlipParts;
  return {
      of(words.along, [](const P& p) { return Vec3(-right_of(p)); }),
      of(words.no_limit, [](const P& p) { return narrow(-p.mass * p.slip); }),
      of(words.always_limit, [](const P& p) { return along(p.cone, p.slip); }),
      of(words.no_mu, [](const P& p) { return narrow(braked(p.mass * p.slip, p.pressed)); }),
      of(words.whole, [](const P& p) { return narrow(braked(p.mass * p.whole, p.cone)); }),
      of(words.whole_length,
         [](const P& p) { return along(std::min(p.cone, p.mass * p.whole.norm()), p.slip); }),
      of("the larger of the two is taken: take the smaller",
         [](const P& p) { return along(std::max(p.cone, p.mass * p.slip.norm()), p.slip); }),
      of(words.over_whole,
         [](const P& p) {
           const Real size = std::min(p.cone, p.mass * p.whole.norm());
           return narrow(p.whole.norm() == 0 ? VecL(VecL::Zero())
                                             : VecL(-size / p.whole.norm() * p.slip));
         }),
      of(words.not_unit,
         [](const P& p) { return narrow(-std::min(p.cone, p.mass * p.slip.norm()) * p.slip); }),
      of(words.none, [](const P&) { return Vec3(Vec3::Zero()); }),
      at_tiny_slips<Input>(words.small, [](double share) { return share == 0.0; }),
      at_tiny_slips<Input>(words.padded, [](double share) { return share > 0.0 && share < 0.5; }),
      {words.nan, [](const Input& c, const Vec3& got) {
         const P p = parts(c);
         return p.slip.norm() == 0 ? !is_finite(got) : near(got, right_of(p));
       }}};
}

/// Clamped and not, along an axis and across, without slip and with hardly any.
std::vector<FrictionCase> friction_inputs() {
  return {{2.0, {3.0, 4.0, -1.0}, up, 4.0, 0.5},       {2.0, {3.0, 4.0, -1.0}, up, 40.0, 0.5},
          {3.0, {1.0, -2.0, 2.5}, oblique, 1.5, 0.25}, {0.5, {1.0, -2.0, 2.5}, oblique, 7.0, 0.75},
          {2.0, {0.0, 0.0, -3.0}, up, 4.0, 0.5},       {2.0, {3e-100, 4e-100, -1.0}, up, 4.0, 0.5}};
}

std::vector<CorrectionCase> correction_inputs() {
  return {{{3.0, 4.0, -1.0}, up, 4.0, 0.5},       {{3.0, 4.0, -1.0}, up, 40.0, 0.5},
          {{1.0, -2.0, 2.5}, oblique, 1.5, 0.25}, {{1.0, -2.0, 2.5}, oblique, 7.0, 0.75},
          {{0.0, 0.0, -3.0}, up, 4.0, 0.5},       {{3e-100, 4e-100, -1.0}, up, 4.0, 0.5}};
}

std::vector<Mistake<FrictionCase, Vec3>> friction_mistakes() {
  auto all = slip_mistakes<FrictionCase>(
      {"friction is along the slip, so it pushes on: change its sign",
       "friction stops all slip: limit it to mu j_n",
       "friction is always mu j_n: a small slip needs only m |v_t|",
       "mu is missing: multiply by mu",
       "the whole velocity is braked: brake only its tangential part",
       "m |v| is used instead of m |v_t| in the smaller of the two",
       "|v| is used instead of |v_t|: divide v_t by its own length",
       "the slip is not made a unit vector: divide it by its length",
       "there is no friction: add the tangential impulse",
       "a small slip is taken for zero: test only for exactly zero",
       "something is added to |v_t|, so a small slip is braked too little: divide by |v_t| itself",
       "without slip this is 0/0: v_t has no direction then, so return zero"});
  using C = FrictionCase;
  all.push_back(returns<C, Vec3>(
      "the mass is missing in m |v_t|: multiply |v_t| by m",
      [](const C& c) { return along(std::min(cone(c), slip(c).norm()), slip(c)); }));
  all.push_back(returns<C, Vec3>("the impulse is divided by the mass: return it as it is",
                                 [](const C& c) { return Vec3(exact_friction(c) / c.mass); }));
  return all;
}

std::vector<Mistake<CorrectionCase, Vec3>> correction_mistakes() {
  return slip_mistakes<CorrectionCase>(
      {"the correction is along the slip, so it slides on: change its sign",
       "all of the slip is undone: undo no more than mu d_n",
       "it is always mu d_n: undo no more than the slip itself", "mu is missing: multiply by mu",
       "the whole displacement is undone: undo only its tangential part",
       "|d| is used instead of |d_t| in the smaller of the two",
       "|d| is used instead of |d_t|: divide d_t by its own length",
       "the slip is not made a unit vector: divide it by its length",
       "there is no tangential correction: add it",
       "a small slip is taken for zero: test only for exactly zero",
       "something is added to |d_t|, so a small slip is moved back too little: divide by |d_t| "
       "itself",
       "without slip this is 0/0: d_t has no direction then, so return zero"});
}

std::vector<DepthCase> depth_inputs() {
  return {{-0.25, up}, {-2.0, oblique}, {0.5, up}, {0.75, oblique}, {-1e-100, up}, {1e-100, up}};
}

std::vector<Mistake<DepthCase, Vec3>> depth_mistakes() {
  using C = DepthCase;
  const auto of = [](const std::string& story, const auto& value) {
    return returns<C, Vec3>(story, value);
  };
  const std::string inwards = "the particle is pushed inwards: use -phi n, not +phi n";
  const std::string pulled = "a particle outside is pulled to the surface: return zero if phi >= 0";
  return {of(inwards, [](const C& c) { return Vec3(std::min(c.gap, 0.0) * c.normal); }),
          of(inwards, [](const C& c) { return Vec3(c.gap * c.normal); }),
          of(pulled, [](const C& c) { return Vec3(-c.gap * c.normal); }),
          of("a particle outside is moved, too: return zero if phi >= 0",
             [](const C& c) { return Vec3(std::abs(c.gap) * c.normal); }),
          of("there is no normal correction: return -phi n if phi < 0",
             [](const C&) { return Vec3(Vec3::Zero()); }),
          {"a small depth is taken for zero: test only whether phi < 0",
           [](const C& c, const Vec3& got) {
             return near(got, c.gap > -tiny ? Vec3(Vec3::Zero()) : exact_depth(c));
           }}};
}

}  // namespace

std::string likely_of_normal_impulse() {
  return fingerprint(
      normal_inputs(),
      [](const NormalCase& c) {
        return lab::impulse_response::normal_impulse(c.mass, c.velocity, c.normal, c.restitution);
      },
      normal_mistakes());
}

std::string likely_of_friction_impulse() {
  return fingerprint(
      friction_inputs(),
      [](const FrictionCase& c) {
        return lab::impulse_response::friction_impulse(c.mass, c.velocity, c.normal,
                                                       c.normal_impulse, c.friction);
      },
      friction_mistakes());
}

std::string likely_of_normal_correction() {
  return fingerprint(
      depth_inputs(),
      [](const DepthCase& c) { return lab::impulse_response::normal_correction(c.gap, c.normal); },
      depth_mistakes());
}

std::string likely_of_tangential_correction() {
  return fingerprint(
      correction_inputs(),
      [](const CorrectionCase& c) {
        return lab::impulse_response::tangential_correction(c.displacement, c.normal,
                                                            c.normal_length, c.friction);
      },
      correction_mistakes());
}

}  // namespace tests
