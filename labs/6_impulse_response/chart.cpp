// Error against computing time of the two ways to step: where a particle leaves the cylinder, when
// a ball bounces, and how far a particle slides on an incline.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "impulse_response.hpp"
#include "render/chart_program.hpp"

using namespace lab::impulse_response;
namespace palette = render::palette;

namespace {

constexpr double weight = 9.81;  // g [m/s²]
const Vec3 gravity(0.0, 0.0, -weight);

std::vector<double> powers_of_two(int first, int last, int factor) {
  std::vector<double> ladder;
  for (int steps = first; steps <= last; steps *= factor) ladder.push_back(steps);
  return ladder;
}

/// `run` maps the number of steps a second to an error and the steps that it took.
template <typename Run>
render::Method method(const char* name, double order, render::Colour colour,
                      const std::vector<double>& ladder, double failure, const Run& run) {
  render::Method result{name, order, colour, ladder, nullptr, nullptr};
  result.judge = [=](double steps_a_second) {
    const auto [error, steps] = run(1.0 / steps_a_second);
    const bool is_known = error < failure;
    return render::Judgement{is_known ? error : failure, static_cast<double>(steps), is_known};
  };
  result.run = [=](double steps_a_second) {
    volatile double kept = run(1.0 / steps_a_second).error;  // or nothing would be computed
    static_cast<void>(kept);
  };
  return result;
}

struct Outcome {
  double error = 0.0;
  int steps = 0;
};

/// A step of either option.
struct Step {
  Particle particle;
  bool pushed = false;  ///< by an impulse of option 2
  std::vector<Impact> impacts;
};

auto by_projection(const Corrections& corrections) {
  return
      [=](const Particle& particle, const Obstacle& obstacle, const Material& material, double dt) {
        const ProjectedStep next =
            step_by_projection(particle, obstacle, material, gravity, dt, corrections);
        return Step{next.particle, !next.impulse.isZero(0.0), {}};
      };
}

auto by_impacts(int max_impacts) {
  return [=](const Particle& particle, const Obstacle& obstacle, const Material& material,
             double dt) {
    const ImpactStep next = step_to_impact(particle, obstacle, material, gravity, dt, max_impacts);
    return Step{next.particle, false, next.impacts};
  };
}

// Letting go.

constexpr double radius = 1.0;
constexpr double first_start = 0.1;  // from the top [rad]
constexpr int starts = 8;            // evenly, so that no luck of the last step shows
constexpr double start_speed = 1.0;

/// ½ v² = ½ v₀² + g R (cos θ₀ − cos θ), and it leaves where v² = g R cos θ.
double exact_departure(double start_angle) {
  return std::acos(2.0 / 3.0 * std::cos(start_angle) +
                   start_speed * start_speed / (3.0 * weight * radius));
}

double angle_of(const Particle& particle) {
  return std::atan2(particle.position.y(), particle.position.z());
}

enum class Departure { last_contact, last_impulse };

/// Slides without friction until it is outside for good.
template <typename Advance>
Outcome slide(const Advance& advance, Departure departure, double start_angle, double dt) {
  const Obstacle cylinder = common::Cylinder{radius};
  const Vec3 outward(0.0, std::sin(start_angle), std::cos(start_angle));
  const Vec3 along(0.0, std::cos(start_angle), -std::sin(start_angle));
  Particle particle{1.0, radius * outward, start_speed * along};
  double angle = start_angle;
  Outcome outcome;
  while (angle_of(particle) < 0.5 * std::numbers::pi && outcome.steps * dt < 2.0) {
    const Step step = advance(particle, cylinder, {0.0, 0.0}, dt);
    particle = step.particle;
    ++outcome.steps;
    constexpr double rounding = 1e-14;
    const bool touches = common::gap(cylinder, particle.position) < rounding;
    const bool holds = departure == Departure::last_contact ? touches : step.pushed;
    if (!touches || (!holds && angle > 2.0 * first_start)) break;
    if (holds) angle = angle_of(particle);
  }
  outcome.error = std::abs(angle - exact_departure(start_angle));
  return outcome;
}

/// The largest error of all starts.
template <typename Advance>
auto letting_go(const Advance& advance, Departure departure) {
  return [=](double dt) {
    Outcome all;
    for (int i = 0; i < starts; ++i) {
      const Outcome one = slide(advance, departure, first_start + 0.01 * i / starts, dt);
      all.error = std::max(all.error, one.error);
      all.steps += one.steps;
    }
    return all;
  };
}

render::MeasuredChart departure_chart() {
  render::Chart words;
  words.title = "Letting go of a cylinder: error against computing time";
  words.subtitle =
      "no friction, from about 0.1 rad off the top at 1 m/s, largest of eight starts; dashed: "
      "theory";
  words.lab = "6_impulse_response";
  words.error_name = "error of the angle of departure";
  words.error_unit = "rad";
  words.work_unit = "eight slides";
  words.parameter_name = "steps a second";
  const std::vector<double> ladder = powers_of_two(16, 65536, 2);
  const auto option_2 = by_projection({true, true});
  const auto sinking = by_projection({false, true});
  return {words,
          {method("option 2, last contact", 0.5, palette::vermilion, ladder, HUGE_VAL,
                  letting_go(option_2, Departure::last_contact)),
           method("option 2, last impulse", 1.0, palette::orange, ladder, HUGE_VAL,
                  letting_go(option_2, Departure::last_impulse)),
           method("last impulse, not moved out", 1.0, palette::purple, ladder, HUGE_VAL,
                  letting_go(sinking, Departure::last_impulse)),
           method("option 1, last contact", 1.0, palette::green, ladder, HUGE_VAL,
                  letting_go(by_impacts(8), Departure::last_contact))}};
}

// Bounces.

constexpr double height = 1.0;
constexpr double restitution = 0.8;
constexpr int bounces = 10;

/// The fall takes √(2 h/g), the k-th flight 2 eᵏ v₀/g.
std::vector<double> exact_bounces() {
  const double fall = std::sqrt(2.0 * height / weight);
  std::vector<double> times{fall};
  double flight = 2.0 * fall;
  for (int k = 1; k < bounces; ++k) {
    flight *= restitution;
    times.push_back(times.back() + flight);
  }
  return times;
}

double last_flight() {
  const std::vector<double> times = exact_bounces();
  return times[bounces - 1] - times[bounces - 2];
}

template <typename Advance>
auto bouncing(const Advance& advance) {
  return [=, exact = exact_bounces()](double dt) {
    const Obstacle ground = common::Plane{};
    Particle particle{1.0, {0.0, 0.0, height}, Vec3::Zero()};
    std::vector<double> times;
    Outcome outcome;
    while (times.size() < bounces && outcome.steps * dt < exact.back() + 1.0) {
      const Step step = advance(particle, ground, {restitution, 0.0}, dt);
      particle = step.particle;
      for (const Impact& impact : step.impacts) times.push_back(outcome.steps * dt + impact.time);
      ++outcome.steps;
      if (step.pushed) times.push_back(outcome.steps * dt);
    }
    times.resize(bounces, HUGE_VAL);
    for (std::size_t k = 0; k < bounces; ++k) {
      outcome.error = std::max(outcome.error, std::abs(times[k] - exact[k]));
    }
    return outcome;
  };
}

render::MeasuredChart bounces_chart() {
  render::Chart words;
  words.name = "bounces";
  words.title = "Ten bounces: error of their times against computing time";
  words.subtitle =
      "a ball dropped from 1 m, e = 0.8; cap: impacts a step before option 2 takes over; dashed: "
      "theory";
  words.lab = "6_impulse_response";
  words.error_name = "largest error of ten bounce times";
  words.error_unit = "s";
  words.work_unit = "ten bounces";
  words.parameter_name = "steps a second";
  words.failure_error = last_flight();
  words.failure_text = "off by the last flight and above: a bounce is missed or made up";
  words.rounding_floor = 2.2e-16;
  std::vector<double> from_one_step{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0};
  const auto option_1 = [&](const char* name, render::Colour colour, int max_impacts) {
    return method(name, 0.0, colour, from_one_step, last_flight(),
                  bouncing(by_impacts(max_impacts)));
  };
  return {
      words,
      {method("option 2", 1.0, palette::vermilion, powers_of_two(16, 65536, 2), last_flight(),
              bouncing(by_projection({true, true}))),
       option_1("option 1, cap 1", palette::sky, 1), option_1("option 1, cap 4", palette::blue, 4),
       option_1("option 1, cap 16", palette::green, 16)}};
}

// An incline.

constexpr double friction = 0.5;
constexpr double sliding_time = 1.0;

/// From rest, in the time: ½ g (sin θ − μ cos θ) t², or 0 where tan θ ≤ μ.
double exact_slide(double angle) {
  const double pull = std::sin(angle) - friction * std::cos(angle);
  return 0.5 * weight * std::max(0.0, pull) * sliding_time * sliding_time;
}

template <typename Advance>
auto sliding(const Advance& advance, double tangent) {
  return [=](double dt) {
    const double angle = std::atan(tangent);
    const Vec3 down_the_slope(std::cos(angle), 0.0, -std::sin(angle));
    const Obstacle slope = common::Plane{Vec3::Zero(), {std::sin(angle), 0.0, std::cos(angle)}};
    Particle particle{1.0, Vec3::Zero(), Vec3::Zero()};
    Outcome outcome;
    outcome.steps = static_cast<int>(std::lround(sliding_time / dt));
    for (int i = 0; i < outcome.steps; ++i) {
      particle = advance(particle, slope, {0.0, friction}, dt).particle;
    }
    outcome.error = std::abs(down_the_slope.dot(particle.position) - exact_slide(angle));
    return outcome;
  };
}

render::MeasuredChart incline_chart() {
  render::Chart words;
  words.name = "incline";
  words.title = "A particle on a slope: error against computing time";
  words.subtitle =
      "μ = 0.5, a second from rest. tan θ = 0.9 μ: must rest; 1.1 μ: slides. At the foot: 0. "
      "Dashed: theory";
  words.lab = "6_impulse_response";
  words.error_name = "error of the distance slid";
  words.error_unit = "m";
  words.work_unit = "simulated second";
  words.parameter_name = "steps a second";
  const std::vector<double> ladder = powers_of_two(16, 65536, 4);
  const auto option_2 = by_projection({true, true});
  const auto creeping = by_projection({true, false});
  const auto option_1 = by_impacts(8);
  const double rests = 0.9 * friction;
  const double slides = 1.1 * friction;
  return {
      words,
      {method("rests: option 2, not corrected", 1.0, palette::vermilion, ladder, HUGE_VAL,
              sliding(creeping, rests)),
       method("slides: option 2, not corrected", 1.0, palette::orange, ladder, HUGE_VAL,
              sliding(creeping, slides)),
       method("slides: option 2", 1.0, palette::purple, ladder, HUGE_VAL,
              sliding(option_2, slides)),
       method("slides: option 1", 1.0, palette::sky, ladder, HUGE_VAL, sliding(option_1, slides)),
       method("rests: option 2", 0.0, palette::blue, ladder, HUGE_VAL, sliding(option_2, rests)),
       method("rests: option 1", 0.0, palette::green, ladder, HUGE_VAL, sliding(option_1, rests))}};
}

}  // namespace

int main(int argc, char** argv) {
  return render::chart_main(argc, argv,
                            {{departure_chart(), bounces_chart(), incline_chart()}, {}, {}});
}
