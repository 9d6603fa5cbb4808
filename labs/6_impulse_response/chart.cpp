// These charts show error against computing time of the two ways to step: the angle at which a
// particle leaves the cylinder, the times at which a ball bounces, and the way that a particle
// slides on an incline.
#include <cmath>
#include <vector>

#include "chart_motions.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::impulse_response;
namespace palette = render::palette;

namespace {

/// Returns a method. `run` maps the number of steps a second to an error and the steps taken.
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
    volatile double kept = run(1.0 / steps_a_second).error;  // otherwise nothing would be computed
    static_cast<void>(kept);
  };
  return result;
}

render::MeasuredChart departure_chart() {
  render::Chart words;
  words.title = "Leaving a cylinder: error against computing time";
  words.subtitle =
      "no friction, from about 0.1 rad off the top at 1 m/s, largest of eight starts; dashed: "
      "theory";
  words.lab = "6_impulse_response";
  words.error_name = "error of the angle of departure";
  words.error_unit = "rad";
  words.work_unit = "eight slides";
  words.parameter_name = "steps a second";
  const std::vector<double> ladder = render::ladder(16, 65536);
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

render::MeasuredChart bounces_chart() {
  render::Chart words;
  words.name = "bounces";
  words.title = "Ten bounces: error of their times against computing time";
  words.subtitle =
      "a ball dropped from 1 m, e = 0.8; cap: impacts per step before option 2 takes over; dashed: "
      "theory";
  words.lab = "6_impulse_response";
  words.error_name = "largest error of ten bounce times";
  words.error_unit = "s";
  words.work_unit = "ten bounces";
  words.parameter_name = "steps a second";
  words.failure_error = last_flight();
  words.failure_text = "off by the last flight or more: a bounce is missed or invented";
  words.rounding_floor = 2.2e-16;
  std::vector<double> from_one_step{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0};
  const auto option_1 = [&](const char* name, render::Colour colour, int max_impacts) {
    return method(name, 0.0, colour, from_one_step, last_flight(),
                  bouncing(by_impacts(max_impacts)));
  };
  return {
      words,
      {method("option 2", 1.0, palette::vermilion, render::ladder(16, 65536), last_flight(),
              bouncing(by_projection({true, true}))),
       option_1("option 1, cap 1", palette::sky, 1), option_1("option 1, cap 4", palette::blue, 4),
       option_1("option 1, cap 16", palette::green, 16)}};
}

render::MeasuredChart incline_chart() {
  render::Chart words;
  words.name = "incline";
  words.title = "A particle on a slope: error against computing time";
  words.subtitle =
      "μ = 0.5, one second from rest. tan θ = 0.9 μ: must rest; 1.1 μ: slides. At the bottom: 0. "
      "Dashed: theory";
  words.lab = "6_impulse_response";
  words.error_name = "error of the distance slid";
  words.error_unit = "m";
  words.work_unit = "simulated second";
  words.parameter_name = "steps a second";
  const std::vector<double> ladder = render::ladder(16, 65536, 4);
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
