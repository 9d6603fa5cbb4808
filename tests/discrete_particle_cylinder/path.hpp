#pragma once

#include <string>
#include <vector>

#include "discrete_particle_cylinder.hpp"
#include "judgement.hpp"
#include "random.hpp"

/// Sampled paths: where a particle is at each sample, rounded once.
namespace tests {

namespace story {
inline const std::string last_sample =
    "this is not the first sample in contact but a later one: stop at the first";
}  // namespace story

struct Flight {
  lab::discrete_particle_cylinder::StraightPath path;
  int samples = 4;
  double particle_radius = 0.5;
  Cylinder cylinder;

  [[nodiscard]] double step() const { return path.duration / samples; }
  [[nodiscard]] double size() const {
    return length(path.position) + length(Vec3(path.velocity * path.duration));
  }
  [[nodiscard]] Meeting at(double time) const {
    Vec3 position;
    for (int i = 0; i < 3; ++i) position(i) = std::fma(time, path.velocity(i), path.position(i));
    return {position, particle_radius, cylinder, time};
  }
};

inline Trial flight_trial(const Flight& f, int index = 1, int count = 1) {
  return radii_trial("3.4 first_sampled_contact", f.particle_radius, f.cylinder, index, count)
      .given("path.position", f.path.position)
      .given("path.velocity", f.path.velocity)
      .given("path.duration", f.path.duration)
      .given("samples", static_cast<double>(f.samples));
}

/// The time of a contact, where there is one.
struct FoundTime {
  std::optional<double> time;
};

inline bool is_finite(const FoundTime& value) { return !value.time || is_finite(*value.time); }
inline double length(const FoundTime& value) { return std::abs(value.time.value_or(0.0)); }
inline double difference(const FoundTime& a, const FoundTime& b) {
  if (a.time.has_value() != b.time.has_value()) return infinity;
  return a.time ? std::abs(*a.time - *b.time) : 0.0;
}
inline std::string text(const FoundTime& value) {
  return value.time ? "a contact at time " + text(*value.time) : "no contact";
}

/// k·`duration`/`intervals` for k from `first` to `last`.
inline std::vector<double> times(double duration, int intervals, int first, int last) {
  std::vector<double> all;
  for (int k = first; k <= last; ++k) all.push_back(rounded(Exact(duration) * k / intervals));
  return all;
}
inline std::vector<double> sample_times(const Flight& f) {
  return times(f.path.duration, f.samples, 0, f.samples);
}

inline FoundTime first_in(const Flight& f, const std::vector<double>& all) {
  const Exact sum = rho(f.particle_radius, f.cylinder);
  for (const double time : all) {
    if (square(f.at(time).position) <= sum * sum) return {time};
  }
  return {};
}

/// The least |gap| over the samples: where it is of the size of rounding, either answer is right.
inline double nearest_to_touching(const Flight& f) {
  double least = infinity;
  const double sum = f.particle_radius + f.cylinder.radius;
  for (int k = 0; k <= f.samples; ++k) {
    const Vec3 position = f.at(f.step() * k).position;
    least = std::min(least, std::abs(std::hypot(position.y(), position.z()) - sum));
  }
  return least;
}

inline std::vector<Suspect<FoundTime>> suspects_of_time(const Flight& f) {
  const std::vector<double> all = sample_times(f);
  const double T = f.path.duration;
  const int N = f.samples;
  FoundTime touching_missed;
  for (auto time = all.rbegin(); time != all.rend(); ++time) {
    if (f.at(*time).gap() < 0.0) touching_missed = {*time};
  }
  const std::vector<double> shares = times(1.0, N, 0, N);
  FoundTime at_share;
  for (std::size_t k = shares.size(); k-- > 0;) {
    if (f.at(shares[k]).gap() <= 0.0) at_share = {all[k]};
  }
  return {
      {first_in(f, {all.rbegin(), all.rend()}), story::last_sample},
      {at_share, "the position is taken at the time k/N: take it at k T/N"},
      {first_in(f, times(T, N, 1, N)), "the start is a sample too: begin at k = 0"},
      {first_in(f, times(T, N, 0, N - 1)), "the end is a sample too: go on to k = N"},
      {first_in(f, times(1.0, N, 0, N)), "the samples end at 1 s: multiply k/N by the duration"},
      {touching_missed, story::touching},
      {FoundTime{0.0}, story::no_time}};
}

/// A straight way across the cylinder, b beside the axis: in contact along a chord of length L.
struct Crossing {
  double particle_radius;
  Cylinder cylinder;
  double offset;  ///< b [m]
  double speed;   ///< across the cylinder [m/s]
  double angle;   ///< of the way about the axis
  double chord;   ///< L [m]

  /// Sampled every c/`ratio`, from four and a share `phase` of such steps before the middle.
  [[nodiscard]] Flight flight(double ratio, double phase) const {
    const double step = chord / ratio;
    Flight f;
    f.path.position = rolled(Vec3(0.0, (phase - 5.0) * step, offset), angle);
    f.path.velocity = rolled(Vec3(0.5, speed, 0.0), angle);
    f.samples = 10;
    f.path.duration = f.samples * step / speed;
    f.particle_radius = particle_radius;
    f.cylinder = cylinder;
    return f;
  }
  /// When the particle of such a flight touches first [s].
  [[nodiscard]] double entry(const Flight& f) const {
    const double before = -rolled(f.path.position, -angle).y();
    return (before - 0.5 * chord) / speed;
  }
};

inline Crossing random_crossing(Random& random) {
  Crossing crossing{random.uniform(0.1, 0.5), {random.uniform(0.3, 1.5)}, 0.0, 0.0, 0.0, 0.0};
  crossing.offset =
      random.uniform(0.0, 0.9) * (crossing.particle_radius + crossing.cylinder.radius);
  crossing.speed = random.uniform(1.0, 5.0);
  crossing.angle = random_angle(random);
  const Exact sum = rho(crossing.particle_radius, crossing.cylinder);
  crossing.chord = rounded(2 * sqrt(sum * sum - Exact(crossing.offset) * crossing.offset));
  return crossing;
}

}  // namespace tests
