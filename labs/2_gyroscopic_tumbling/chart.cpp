// These charts show attitude error against computing time over fifty revolutions, for a racket that
// turns over, a body that tumbles and a heavy top. They also show energy and |L| of the tumble
// through ten minutes of 60 Hz.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "chart_motions.hpp"
#include "common/rotation/attitude.hpp"
#include "common/rotation/rk4_one_exponential.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::gyroscopic_tumbling;
namespace palette = render::palette;

namespace {

constexpr int revolutions = 50;
constexpr double nothing_is_known = 1.0;  // [rad]: an attitude this far off tells nothing

/// Returns the largest error at the ends of all revolutions.
template <typename Start>
render::Judgement judge(const Problem& problem, int steps, const Start& begun) {
  double largest = 0.0;
  try {
    auto motion = begun(problem, problem.revolution / steps);
    for (int k = 1; k <= revolutions; ++k) {
      for (int i = 0; i < steps; ++i) motion.advance();
      const Quat exact = problem.exact(k * problem.revolution).world_from_body;
      const double error = common::angle_between(motion.spin().world_from_body, exact);
      largest = std::isfinite(error) ? std::max(largest, error) : std::numbers::pi;
    }
  } catch (const std::domain_error&) {  // no step of this length exists
    largest = std::numbers::pi;
  }
  return {largest, static_cast<double>(revolutions * steps), largest < nothing_is_known};
}

/// Returns a method whose parameter is the number of steps a revolution. `begun` makes the motion
/// at its start from a problem and dt. Its preparations are timed along with the steps.
template <typename Start>
render::Method method(const char* name, double order, render::Colour colour, const Problem& problem,
                      const std::vector<double>& ladder, const Start& begun) {
  render::Method result{name, order, colour, ladder, nullptr, nullptr};
  result.judge = [=](double steps) { return judge(problem, static_cast<int>(steps), begun); };
  result.run = [=](double steps) {
    auto motion = begun(problem, problem.revolution / steps);
    const int total = revolutions * static_cast<int>(steps);
    for (int i = 0; i < total; ++i) motion.advance();
    volatile double kept = motion.spin().world_from_body.w();  // so that it is computed
    static_cast<void>(kept);
  };
  return result;
}

/// Runs another engine on the same motion. Its world is made before the clock starts.
render::Method peer_method(const Peer& peer, const Problem& problem, double weight_moment) {
  const auto begun = [=](const Problem& p, double dt) {
    return PeerMotion{peer.make(p.moments, p.start, dt), weight_moment};
  };
  render::Method result =
      method(peer.name.c_str(), 1.0, {}, problem, render::ladder(16, 16384, 4), begun);
  const auto motion = std::make_shared<PeerMotion>();
  result.prepare = [=](double steps) { *motion = begun(problem, problem.revolution / steps); };
  result.run = [=](double steps) {
    motion->body->place(problem.start);
    const int total = revolutions * static_cast<int>(steps);
    for (int i = 0; i < total; ++i) motion->advance();
  };
  result.is_peer = true;
  return result;
}

std::vector<render::Method> free_methods(const Problem& p) {
  const std::vector<double> fine = render::ladder(64, 16384);
  const std::vector<double> middle = render::ladder(8, 4096);
  const std::vector<double> coarse = render::ladder(8, 1024);
  return {
      method("explicit loop", 1.0, palette::vermilion, p, fine, by_loop(0.0)),
      method("implicit, as engines do", 1.0, palette::orange, p, fine, by(step_implicit)),
      method("RK4, one exponential", 2.0, palette::grey, p, middle,
             by(common::step_rk4_one_exponential)),
      method("splitting 1-2-3-2-1", 2.0, palette::sky, p, middle, by(step_splitting)),
      method("RK4 on (q, ω)", 4.0, palette::blue, p, middle, by(step_rk4)),
      method("Moser-Veselov", 2.0, palette::purple, p, coarse, by_moser_veselov(no_correction)),
      method("Moser-Veselov, corrected", 4.0, palette::purple, p, coarse,
             by_moser_veselov(own_correction)),
      method("Moser-Veselov, four corrections", 10.0, palette::purple, p, render::ladder(8, 64),
             by_moser_veselov(tenth_order_correction)),
      method("exact step", 0.0, palette::green, p, render::ladder(1, 64), exactly()),
  };
}

std::vector<render::Method> top_methods(const Problem& p) {
  const std::vector<double> fine = render::ladder(32, 16384);
  const std::vector<double> middle = render::ladder(2, 2048);
  return {
      method("explicit loop", 1.0, palette::vermilion, p, fine, by_loop(heavy_top.weight_moment)),
      method("kicks, implicit between", 1.0, palette::orange, p, fine,
             between_kicks(step_implicit)),
      method("kicks, splitting between", 2.0, palette::sky, p, middle,
             between_kicks(step_splitting)),
      method("kicks, RK4 between", 2.0, palette::blue, p, middle, between_kicks(step_rk4)),
      method("kick-drift-kick", 2.0, palette::purple, p, middle,
             [](const Problem& problem, double dt) {
               return Stepping{problem.start, [dt](const Spin& spin) {
                                 return step_kick_drift_kick(heavy_top, spin, dt);
                               }};
             }),
      method("the same in triple jumps", 4.0, palette::green, p, render::ladder(2, 512),
             by_triple_jump()),
  };
}

render::MeasuredChart chart(const char* name, const char* title, const char* subtitle,
                            const std::vector<render::Method>& methods) {
  render::Chart chart;
  chart.name = name;
  chart.lab = "2_gyroscopic_tumbling";
  chart.title = title;
  chart.subtitle = subtitle;
  chart.error_name = "largest attitude error";
  chart.error_unit = "rad";
  chart.work_unit = "50 revolutions";
  chart.parameter_name = "steps a revolution";
  chart.failure_error = nothing_is_known;
  chart.failure_text = "from one radian on, the attitude is lost";
  chart.rounding_floor = 2.2e-16;
  return {chart, methods};
}

/// Records the constants of a motion, once a second for ten minutes at 60 steps a second.
template <typename Start>
render::HistoryMethod history(const char* name, render::Colour colour, const Problem& problem,
                              const Start& begun) {
  const auto record = [=] {
    const auto energy = [&](const Spin& s) {
      return s.angular_velocity_body.dot(problem.moments.cwiseProduct(s.angular_velocity_body));
    };
    const auto momentum = [&](const Spin& s) {
      return problem.moments.cwiseProduct(s.angular_velocity_body).norm();
    };
    constexpr double lost = 10.0;       // times the energy at the start
    constexpr double rounding = 1e-16;  // drawn at the foot of a logarithmic axis
    render::History kept{{}, {{}, {}}, ""};
    auto motion = begun(problem, 1.0 / 60.0);
    for (int second = 1; second <= 600; ++second) {
      for (int i = 0; i < 60; ++i) motion.advance();
      const double energy_off = energy(motion.spin()) / energy(problem.start) - 1.0;
      if (!(std::abs(energy_off) < lost)) {
        kept.end = "blew up";
        break;
      }
      const double momentum_off = momentum(motion.spin()) / momentum(problem.start) - 1.0;
      kept.times.push_back(second);
      kept.values[0].push_back(std::max(std::abs(energy_off), rounding));
      kept.values[1].push_back(std::max(std::abs(momentum_off), rounding));
    }
    return kept;
  };
  return {name, colour, record};
}

render::RecordedChart long_run(const Problem& p) {
  render::HistoryChart chart;
  chart.name = "history";
  chart.lab = "2_gyroscopic_tumbling";
  chart.title = "Ten minutes of tumbling at 60 steps a second";
  chart.subtitle = "how much the methods change energy and angular momentum";
  chart.panels = {{"|E/E(0) − 1|", "", true, 1e-16, 10.0, {}},
                  {"||L|/|L(0)| − 1|", "", true, 1e-16, 10.0, {}}};
  return {
      chart,
      {history("explicit loop", palette::vermilion, p, by_loop(0.0)),
       history("implicit, as engines do", palette::orange, p, by(step_implicit)),
       history("splitting 1-2-3-2-1", palette::sky, p, by(step_splitting)),
       history("RK4 on (q, ω)", palette::blue, p, by(step_rk4)),
       history("Moser-Veselov, corrected", palette::purple, p, by_moser_veselov(own_correction)),
       history("exact step", palette::green, p, exactly())}};
}

render::ChartPlan plan(const render::ChartRequest& request) {
  const Problem racket = free_problem({0.01, 1.0, 0.01});
  const Problem tumble = free_problem({1.0, 1.0, 1.0});
  const Problem top = top_problem();
  render::ChartPlan plan;
  plan.charts = {
      chart("racket", "A racket turning over: error against computing time",
            "I = (1, 2, 3), one turn per second about the middle axis, off by a hundredth",
            free_methods(racket)),
      chart("tumble", "A tumbling body: error against computing time",
            "I = (1, 2, 3), one turn per second about (1, 1, 1)", free_methods(tumble)),
      chart("top", "A heavy top: error against computing time",
            "leaning by 30°, released with its axis at rest, 30 rad/s about the axis",
            top_methods(top))};
  plan.histories = {long_run(tumble)};
  if (!request.peers) return plan;
  for (const Peer& peer : peers()) {
    if (!peer.make) {
      plan.left_out.push_back(left_out(peer));
      continue;
    }
    plan.charts[0].methods.push_back(peer_method(peer, racket, 0.0));
    plan.charts[1].methods.push_back(peer_method(peer, tumble, 0.0));
    plan.charts[2].methods.push_back(peer_method(peer, top, heavy_top.weight_moment));
    const auto begun = [make = peer.make](const Problem& p, double dt) {
      return PeerMotion{make(p.moments, p.start, dt), 0.0};
    };
    plan.histories[0].methods.push_back(history(peer.name.c_str(), {}, tumble, begun));
    plan.histories[0].methods.back().is_peer = true;
  }
  return plan;
}

}  // namespace

int main(int argc, char** argv) { return render::chart_main(argc, argv, plan); }
