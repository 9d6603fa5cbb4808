// These charts show the error of the time of impact against computing time, for particles near and
// far, and for an edge.
#include <algorithm>
#include <cmath>
#include <memory>

#include "chart_methods.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::continuous_particle_cylinder;
namespace palette = render::palette;

namespace {

constexpr double nothing_is_known = dt;  // the error of a hit missed and of one that is none

double error_of(const std::optional<double>& time, const std::optional<DoubleDouble>& exact) {
  if (!time && !exact) return 0.0;
  if (!time || !exact || !std::isfinite(*time)) return nothing_is_known;
  return std::min(std::abs((DoubleDouble(*time) - *exact).high), nothing_is_known);
}

/// Judges and times `find`, which maps a motion and the ladder's parameter to what it finds.
template <typename Moving, typename Find>
render::Method method(const char* name, render::Colour colour, const std::vector<double>& ladder,
                      const std::shared_ptr<const std::vector<Case<Moving>>>& cases,
                      const Find& find) {
  render::Method result{name, 0.0, colour, ladder, nullptr, nullptr};
  result.judge = [=](double parameter) {
    render::Judgement judgement;
    for (const auto& [moving, exact] : *cases) {
      const Found found = find(moving, parameter);
      judgement.error = std::max(judgement.error, error_of(found.time, exact));
      judgement.evaluations += found.evaluations / static_cast<double>(cases->size());
    }
    judgement.stable = judgement.error < nothing_is_known;
    return judgement;
  };
  result.run = [=](double parameter) {
    double sum = 0.0;
    for (const auto& [moving, exact] : *cases) sum += find(moving, parameter).time.value_or(0.0);
    volatile double kept = sum;  // otherwise nothing would be computed
    static_cast<void>(kept);
  };
  result.units = static_cast<double>(cases->size());
  return result;
}

/// Runs all cases in one call, over and over until there are about ten thousand.
render::Method batch_method(const char* name, render::Colour colour,
                            const std::shared_ptr<const std::vector<Case<MovingParticle>>>& cases) {
  constexpr int copies = 32;
  MovingParticles particles;
  particles.radius = radius;
  for (int copy = 0; copy < copies; ++copy) {
    for (const auto& [moving, exact] : *cases) {
      particles.y.push_back(moving.position.y());
      particles.z.push_back(moving.position.z());
      particles.velocity_y.push_back(moving.velocity.y());
      particles.velocity_z.push_back(moving.velocity.z());
    }
  }
  render::Method result{name, 0.0, colour, {1.0}, nullptr, nullptr};
  result.judge = [=](double /*parameter*/) {
    const std::vector<double> times = times_of_impact(particles, cylinder, dt);
    render::Judgement judgement{0.0, 1.0, true};
    for (std::size_t i = 0; i < cases->size(); ++i) {
      const bool is_hit = times.at(i) <= dt;
      const auto time = is_hit ? std::optional<double>(times[i]) : std::nullopt;
      judgement.error = std::max(judgement.error, error_of(time, (*cases)[i].time));
    }
    judgement.stable = judgement.error < nothing_is_known;
    return judgement;
  };
  result.run = [=](double /*parameter*/) {
    volatile double kept = times_of_impact(particles, cylinder, dt).back();
    static_cast<void>(kept);
  };
  result.units = static_cast<double>(copies) * static_cast<double>(cases->size());
  return result;
}

const std::vector<double> tolerances{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14};

/// The ladders of the methods that have one.
struct Ladders {
  std::vector<double> samples;
  std::vector<double> samples_bisected;
  std::vector<double> tolerances;
};

std::vector<render::Method> particle_methods(double least_distance, double distance,
                                             const Ladders& ladders) {
  const auto cases = std::make_shared<const std::vector<Case<MovingParticle>>>(
      particles(least_distance, distance));
  const auto single = [](const auto& function) {
    return [function](const MovingParticle& particle, double /*parameter*/) {
      return Found{function(particle, cylinder, dt), 1.0};
    };
  };
  return {
      method("samples", palette::vermilion, ladders.samples, cases, sampled),
      method("samples, then bisection", palette::orange, ladders.samples_bisected, cases, bisected),
      method("conservative advancement", palette::purple, ladders.tolerances, cases, advanced),
      method("textbook quadratic", palette::sky, {1.0}, cases, single(time_of_impact_textbook)),
      method("cross form", palette::blue, {1.0}, cases, single(time_of_impact)),
      method("certified", palette::green, {1.0}, cases, single(time_of_impact_certified)),
      batch_method("certified, a batch", palette::ink, cases),
  };
}

std::vector<render::Method> edge_methods() {
  const auto cases = std::make_shared<const std::vector<Case<MovingEdge>>>(edges());
  const auto quartic = [](const MovingEdge& edge, double /*parameter*/) {
    return Found{time_of_impact_of_edge(edge, cylinder, dt), 1.0};
  };
  return {
      method("its ends alone", palette::vermilion, {1.0}, cases, ends_alone),
      method("samples", palette::orange, render::ladder(1, 1024), cases, sampled_edge),
      method("conservative advancement", palette::purple, tolerances, cases, advanced_edge),
      method("quartic", palette::green, {1.0}, cases, quartic),
  };
}

render::MeasuredChart chart(const char* name, const char* title, const char* subtitle,
                            const std::vector<render::Method>& methods) {
  render::Chart chart;
  chart.name = name;
  chart.lab = "4_continuous_particle_cylinder";
  chart.title = title;
  chart.subtitle = subtitle;
  chart.error_name = "largest error of the time of impact";
  chart.error_unit = "dt";
  chart.work_unit = "query";
  chart.parameter_name = "samples, or tolerance [m]";
  chart.failure_error = nothing_is_known;
  chart.failure_text = "a hit is missed or invented: off by dt";
  chart.rounding_floor = 1.1e-16;
  return {chart, methods};
}

}  // namespace

int main(int argc, char** argv) {
  const Ladders near{render::ladder(1, 1024), render::ladder(1, 1024), tolerances};
  const Ladders far{render::ladder(4, 1024, 16), render::ladder(16, 1024, 16), {1e-2, 1e-4, 1e-6}};
  render::ChartPlan plan;
  plan.charts = {
      chart("chart", "A particle's time of impact: error against computing time",
            "from 1.2 to 4 ρ away; 1 to 1024 samples, tolerances of 1e-2 to 1e-14 m",
            particle_methods(1.2, 4.0, near)),
      chart("far", "From far away: error of the time of impact against computing time",
            "from 10⁸ ρ away; 4 to 1024 samples, tolerances of 1e-2 to 1e-6 m",
            particle_methods(0.9e8, 1.1e8, far)),
      chart("edge", "A sweeping edge's time of impact: error against computing time",
            "its ends pass by on both sides; 1 to 1024 samples, tolerances of 1e-2 to 1e-14 m",
            edge_methods())};
  return render::chart_main(argc, argv, plan);
}
