#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "chart_impacts.hpp"
#include "render/chart/chart_program.hpp"

/// The charts whose first axis is no computing time.
namespace lab::multi_contact {

namespace palette = render::palette;

inline constexpr const char* lab_name = "7_multi_contact";

inline render::HistoryChart history_chart(const char* name, const char* title,
                                          const char* subtitle) {
  render::HistoryChart words;
  words.name = name;
  words.lab = lab_name;
  words.title = title;
  words.subtitle = subtitle;
  return words;
}

/// Theory, drawn only beside a method that is written.
inline render::HistoryMethod closed_form(const render::HistoryMethod& beside,
                                         const std::string& name,
                                         const std::function<render::History()>& line) {
  return {name, {}, [=] { return beside.record(), line(); }, true};
}

inline render::RecordedChart collapse_chart() {
  render::HistoryChart words =
      history_chart("collapse", "A ball hits balls at rest: impulses until nothing approaches",
                    "N balls in all, the first comes; at 1000 it has not ended; dashed: e_c = "
                    "tan²(π/4 (1 − 2/N))");
  words.x_name = "restitution e";
  words.x_unit = "";
  words.panels = {{"impulses or reflections", "", true, 1.0, 2000.0, {}}};
  render::RecordedChart chart{words, {}};
  const auto add = [&](int balls, render::Colour colour, render::Colour colour_of_reflections) {
    const std::string of_balls = " of " + std::to_string(balls) + " balls";
    chart.methods.push_back({"impulses" + of_balls, colour,
                             [=] { return counts_by_restitution(balls, impulses_until_apart); }});
    chart.methods.push_back({"reflections" + of_balls, colour_of_reflections, [=] {
                               return counts_by_restitution(
                                   balls, [](const ContactSystem& row, double e) {
                                     return generalized_reflections(row, e, most_impulses).count;
                                   });
                             }});
  };
  add(5, palette::vermilion, palette::blue);
  add(3, palette::orange, palette::sky);
  for (const int balls : {5, 3}) {
    chart.methods.push_back(closed_form(chart.methods[0], std::to_string(balls) + " balls",
                                        [=] { return collapse_wall(balls); }));
  }
  return chart;
}

inline render::RecordedChart pi_chart() {
  render::HistoryChart words = history_chart(
      "pi", "Two balls and a wall count π",
      "a ball of mass m rests at the wall, a ball of mass M comes, e = 1; M/m = 100 is at 10");
  words.x_name = "√(M/m)";
  words.x_unit = "";
  words.panels = {{"impulses or reflections", "", false, 0.0, 0.0, {}}};
  render::RecordedChart chart{words, {}};
  chart.methods.push_back({"impulses", palette::vermilion, [] {
                             return counts_by_mass([](const ContactSystem& system) {
                               return sequential_impulses(system, 1.0, most_impulses).count;
                             });
                           }});
  chart.methods.push_back({"reflections", palette::sky, [] {
                             return counts_by_mass([](const ContactSystem& system) {
                               return generalized_reflections(system, 1.0, most_impulses).count;
                             });
                           }});
  chart.methods.push_back(closed_form(chart.methods[0], "π √(M/m)", pi_times_root));
  return chart;
}

inline render::RecordedChart slide_chart() {
  const double most = degrees(largest_direction_error());
  render::HistoryChart words = history_chart(
      "slide", "A block slides to rest: by how much friction bends its way",
      "from start to end, for the three bounds of friction; dashed: in closed form, and their "
      "largest error");
  words.x_name = "start's angle φ to the first tangent";
  words.x_unit = "°";
  words.panels = {{"direction of the way − φ", "°", false, -15.0, 15.0, {}}};
  render::RecordedChart chart{words, {}};
  const auto add = [&](const char* name, render::Colour colour, FrictionRule rule) {
    chart.methods.push_back({name, colour, [=] {
                               return directions([=](double angle) { return slide(rule, angle); });
                             }});
  };
  add("box", palette::vermilion, FrictionRule::box);
  add("diamond", palette::blue, FrictionRule::diamond);
  add("disc", palette::green, FrictionRule::disc);
  const auto add_line = [&](const std::string& name, const std::function<render::History()>& line) {
    chart.methods.push_back(closed_form(chart.methods[0], name, line));
  };
  add_line("atan tan² φ − φ", [] { return directions(box_way); });
  add_line("atan sin 2φ − φ", [] { return directions(diamond_way); });
  for (const double error : {most, -most}) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%.2f°", error);
    add_line(name.data(), [=] { return render::History{{0.0, 80.0}, {{error, error}}, ""}; });
  }
  return chart;
}

}  // namespace lab::multi_contact
