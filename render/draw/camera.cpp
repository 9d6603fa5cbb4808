#include "render/draw/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "render/draw/view.hpp"

namespace render {
namespace {

// The eye's possible places across one direction of the picture. A point at (x, z), z towards the
// eye, is seen from (X, D) where |x − X| ≤ slope (D − z); so X lies between the largest
// x + slope z − slope D and the smallest x − slope z + slope D.
struct Sight {
  double slope;
  double largest_sum = -std::numeric_limits<double>::infinity();         // of x + slope z
  double smallest_difference = std::numeric_limits<double>::infinity();  // of x − slope z

  void add(double x, double z) {
    largest_sum = std::max(largest_sum, x + slope * z);
    smallest_difference = std::min(smallest_difference, x - slope * z);
  }
  // The least D that leaves a place for X.
  [[nodiscard]] double least_distance() const {
    return (largest_sum - smallest_difference) / (2 * slope);
  }
  // Halfway between the limits of X, whatever D.
  [[nodiscard]] double middle() const { return (largest_sum + smallest_difference) / 2; }
};

void check(const Bounds& bounds, const Vec3& towards_eye, double aspect, double margin) {
  const auto require = [](bool is_right, const char* message) {
    if (!is_right) throw std::invalid_argument(message);
  };
  require(bounds.low.allFinite() && bounds.high.allFinite(), "camera: bounds are not finite");
  require((bounds.high - bounds.low).minCoeff() >= 0.0 && bounds.low != bounds.high,
          "camera: bounds are empty");
  require(towards_eye.allFinite() && !towards_eye.isZero(0.0),
          "camera: the direction is zero or not finite");
  require(std::isfinite(aspect) && aspect > 0.0, "camera: the aspect is not positive and finite");
  require(margin >= 0.0 && margin < 1.0, "camera: the margin is not in [0, 1)");
}

}  // namespace

Camera camera_framing(const Bounds& bounds, const Vec3& towards_eye, double aspect, double margin) {
  check(bounds, towards_eye, aspect, margin);
  Camera camera;
  const CameraAxes axes = camera_axes(towards_eye);
  const Vec3 centre = bounds.low + (bounds.high - bounds.low) / 2;
  const double slope = std::tan(camera.vertical_angle / 2) * (1.0 - margin);
  Sight across{slope * aspect};
  Sight upright{slope};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1) != 0 ? bounds.high.x() : bounds.low.x(),
                     (corner & 2) != 0 ? bounds.high.y() : bounds.low.y(),
                     (corner & 4) != 0 ? bounds.high.z() : bounds.low.z());
    const Vec3 from_centre = point - centre;
    const double z = axes.backward.dot(from_centre);
    across.add(axes.right.dot(from_centre), z);
    upright.add(axes.up.dot(from_centre), z);
  }
  const double distance = std::max(across.least_distance(), upright.least_distance());
  camera.target = centre + across.middle() * axes.right + upright.middle() * axes.up;
  camera.eye = camera.target + distance * axes.backward;
  return camera;
}

}  // namespace render
