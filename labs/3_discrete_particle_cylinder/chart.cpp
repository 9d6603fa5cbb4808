// These charts show which crossings samples miss, and how late they find the others. They also show
// how much of a cloth is inside, but unseen, if its particles or its edges are checked.
#include <cmath>
#include <memory>
#include <numbers>

#include "chart_triangles.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::discrete_particle_cylinder;
namespace palette = render::palette;

namespace {

constexpr double missed_at_a_diameter = 1.0 - std::numbers::pi / 4.0;  // the mean of 1 − c/s

/// Returns a method. `judged` maps findings to an error, and says whether the samples are of use.
template <typename Judged>
render::Method method(const char* name, double order, render::Colour colour, double diameters,
                      const Judged& judged) {
  const auto all = std::make_shared<const std::vector<Crossing>>(crossings(diameters));
  render::Method result{name, order, colour, render::ladder(1, 1024), nullptr, nullptr};
  result.judge = [=](double samples) {
    const Findings found(*all, steps_a_path * static_cast<int>(samples));
    const auto [error, is_of_use] = judged(found);
    return render::Judgement{error, samples, is_of_use};
  };
  result.run = [=](double samples) {
    double sum = 0.0;
    for (const Crossing& crossing : *all) {
      const auto contact = first_sampled_contact(
          crossing.path, steps_a_path * static_cast<int>(samples), particle_radius, cylinder);
      sum += contact ? contact->time : 0.0;
    }
    volatile double kept = sum;  // otherwise nothing would be computed
    static_cast<void>(kept);
  };
  result.units = static_cast<double>(steps_a_path) * static_cast<double>(all->size());
  return result;
}

render::Chart chart(const char* name, const char* title, const char* subtitle) {
  render::Chart chart;
  chart.name = name;
  chart.lab = "3_discrete_particle_cylinder";
  chart.title = title;
  chart.subtitle = subtitle;
  chart.work_unit = "step";
  chart.parameter_name = "samples a step";
  return chart;
}

render::MeasuredChart missed_chart() {
  render::Chart words = chart("chart", "Crossings that samples miss, against computing time",
                              "1 to 1024 samples per step, at all distances from the axis and in "
                              "all phases; dashed: order in theory");
  words.error_name = "crossings missed";
  words.error_unit = "share";
  words.failure_error = missed_at_a_diameter;
  words.failure_text = "above 1 − π/4: even a path through the axis may be missed";
  const auto missed = [](const Findings& found) {
    return std::pair(found.missed, found.missed < 1.01 * missed_at_a_diameter);
  };
  return {words,
          {method("steps of 10 diameters", 2.0, palette::vermilion, 10.0, missed),
           method("steps of 1 diameter", 2.0, palette::blue, 1.0, missed)}};
}

render::MeasuredChart lateness_chart() {
  render::Chart words = chart(
      "lateness", "How late samples find a contact, against computing time",
      "for the crossings that are found, 1 to 1024 samples per step; dashed: order in theory");
  words.error_name = "delay";
  words.error_unit = "steps";
  const auto largest = [](const Findings& found) {
    return std::pair(found.largest_lateness(), true);
  };
  const auto median = [](const Findings& found) {
    return std::pair(found.median_lateness(), true);
  };
  return {words,
          {method("steps of 10 diameters, largest", 1.0, palette::vermilion, 10.0, largest),
           method("steps of 10 diameters, median", 1.0, palette::orange, 10.0, median),
           method("steps of 1 diameter, largest", 1.0, palette::blue, 1.0, largest),
           method("steps of 1 diameter, median", 1.0, palette::sky, 1.0, median)}};
}

/// Returns a method. `unseen_at` maps the length of an edge to what is unseen.
template <typename UnseenAt>
render::HistoryMethod check(const char* name, render::Colour colour, const UnseenAt& unseen_at) {
  const auto record = [=] {
    render::History kept{{}, {{}, {}}, ""};
    for (int eighths = 2; eighths <= 36; ++eighths) {
      const double length = eighths / 8.0 * reach;
      const Unseen result = unseen_at(length);
      kept.times.push_back(length / reach);
      kept.values[0].push_back(result.share);
      kept.values[1].push_back(result.deepest / reach);
    }
    return kept;
  };
  return {name, colour, record};
}

render::RecordedChart cloth_chart() {
  render::HistoryChart words;
  words.name = "cloth";
  words.lab = "3_discrete_particle_cylinder";
  words.title = "Is it enough to check the particles of a cloth?";
  words.subtitle =
      "equilateral triangles anywhere; the axis passes through some: from h = √3 ρ between "
      "particles, from 2√3 ρ between edges";
  words.x_name = "edge length h";
  words.x_unit = "ρ";
  words.panels = {{"share of the triangles inside that is unseen", "", true, 1e-5, 1.0, {}},
                  {"depth of the deepest unseen triangle", "ρ", false, 0.0, 1.05, {}}};
  const auto by_particles = [](double length) {
    return unseen(length, [](const Triangle& t) { return particles_see(t, 0.0); });
  };
  const auto by_margin = [](double length) {
    const double margin = particle_margin(length, particle_radius, cylinder);
    return unseen(length, [=](const Triangle& t) { return particles_see(t, margin); });
  };
  const auto in_theory = [](double length) {
    const auto [a, b, c] = Triangles(length).at(0);
    triangle_gap(a, b, c, particle_radius, cylinder);  // not written yet: no theory either
    return unseen_by_particles_in_theory(length);
  };
  const auto by_edges = [](double length) { return unseen(length, edges_see); };
  return {words,
          {check("by particles", palette::vermilion, by_particles),
           check("by particles, theory", palette::grey, in_theory),
           check("by edges", palette::blue, by_edges),
           check("by particles at the margin", palette::green, by_margin)}};
}

}  // namespace

int main(int argc, char** argv) {
  return render::chart_main(argc, argv, {{missed_chart(), lateness_chart()}, {cloth_chart()}, {}});
}
