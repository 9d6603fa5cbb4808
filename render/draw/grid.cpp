#include <algorithm>
#include <cmath>

#include "render/draw/strokes.hpp"

namespace render {
namespace {

// The step of 1, 2 or 5 x 10^k nearest below.
double round_step(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double lead = length / power;
  return power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

class Grid {
 public:
  Grid(const View& view, double height)
      : view_(view), height_(height), reach_(ground_reach(view)) {}

  // Lines at constant world x (axis 0) or y (axis 1).
  void add_lines(Strokes& strokes, int axis, double step) const {
    const double centre = view_.origin[axis];
    const auto first = static_cast<long long>(std::ceil((centre - reach_) / step));
    const auto last = static_cast<long long>(std::floor((centre + reach_) / step));
    for (long long i = first; i <= last; ++i) {
      const double off_centre = static_cast<double>(i) * step - centre;
      const double half_length =
          std::sqrt(std::max(0.0, reach_ * reach_ - off_centre * off_centre));
      const double strength = i % 5 == 0 ? 0.30 : 0.15;
      std::vector<StrokePoint> points;
      constexpr int pieces = 20;
      for (int piece = 0; piece <= pieces; ++piece) {
        const double along = half_length * (2.0 * piece / pieces - 1.0);
        Vec3 place(view_.origin.x(), view_.origin.y(), height_);
        place[axis] += off_centre;
        place[1 - axis] += along;
        const Eigen::Vector4f paint = colour(strength, std::hypot(off_centre, along), place);
        constexpr float faintest = 0.008F;  // one or two levels of 255
        if (paint.w() >= faintest) points.push_back({place, paint});
      }
      add_line(strokes, view_, points, std::max(1.0, view_.height / 720.0));
    }
  }

 private:
  [[nodiscard]] Eigen::Vector4f colour(double strength, double off_centre,
                                       const Vec3& place) const {
    const double from_edge = std::max(0.0, 1.0 - off_centre / reach_);
    const double fade = from_edge * from_edge * (3.0 - 2.0 * from_edge);
    // A line keeps a pixel's width, so what is far must be paler for perspective's sake.
    const double distance = std::max(view_.depth(place), 1e-3 * view_.distance);
    const double thinning = std::min(1.0, view_.distance / distance);
    const auto opacity = static_cast<float>(strength * fade * thinning);
    constexpr float ink = 0.03F;
    return {ink, ink, 1.2F * ink, opacity};
  }

  const View& view_;
  double height_;
  double reach_;
};

}  // namespace

double ground_reach(const View& view) {
  const double aspect = static_cast<double>(view.width) / view.height;
  return 3.2 * view.radius * std::max(1.0, aspect);
}

Strokes grid_strokes(const View& view, double ground_height) {
  Strokes strokes;
  const Grid grid(view, ground_height);
  const double step = round_step(view.radius / 1.2);
  for (const int axis : {0, 1}) grid.add_lines(strokes, axis, step);
  return strokes;
}

}  // namespace render
