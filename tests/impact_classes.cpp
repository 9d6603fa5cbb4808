#include "impact_classes.hpp"

#include <cmath>
#include <numbers>

namespace tests {
namespace {

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10.0, random.uniform(low, high));
}

int whole(Random& random, int low, int high) {
  return static_cast<int>(std::floor(random.uniform(low, high + 1)));
}

bool coin(Random& random) { return random.uniform(0.0, 1.0) < 0.5; }

/// Up to two doubles up or down.
double nudged(Random& random, double value) {
  const int steps = whole(random, -2, 2);
  for (int i = 0; i < std::abs(steps); ++i)
    value = std::nextafter(value, steps > 0 ? 1e308 : -1e308);
  return value;
}

/// One of the six numbers of a query, or none, is nudged.
Query nudged(Random& random, Query q) {
  double* const numbers[] = {&q.y, &q.z, &q.v_y, &q.v_z, &q.R, &q.r};
  const int chosen = whole(random, 0, 6);
  if (chosen < 6) *numbers[chosen] = nudged(random, *numbers[chosen]);
  return q;
}

/// A path that passes the axis at a distance of `fraction` ρ, from `length` before its nearest
/// point, at a speed, for a time 1.
Query path(Random& random, double fraction, double length, double speed) {
  const double R = random.uniform(0.5, 2.0);
  const double r = random.uniform(0.01, 0.5);
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double side = fraction * (R + r);
  return {-length * cosine - side * sine,
          -length * sine + side * cosine,
          speed * cosine,
          speed * sine,
          R,
          r,
          1.0};
}

Query generic(Random& random) {
  const auto any = [&](double size) { return random.uniform(-size, size); };
  return {
      any(5.0), any(5.0), any(10.0), any(10.0), random.uniform(0.5, 2.0), random.uniform(0.01, 0.5),
      1.0};
}

Query far(Random& random) {
  const double length = 1e8 * random.uniform(0.5, 1.5);
  return path(random, random.uniform(-1.3, 1.3), length, length * random.uniform(0.9, 1.5));
}

Query fast(Random& random) {
  return path(random, random.uniform(-1.3, 1.3), random.uniform(-1.0, 20.0),
              1e6 * random.uniform(0.5, 1.5));
}

/// The way to the surface is about the speed.
Query slow(Random& random) {
  const double speed = power_of_ten(random, -20.0, -6.0);
  Query q = path(random, 0.0, 0.0, speed);
  const double side = random.uniform(-1.0, 1.0);
  const double reach =
      (q.R + q.r) * (std::sqrt(1.0 - side * side) + speed * random.uniform(0.0, 1.5));
  const double cosine = q.v_y / speed;
  const double sine = q.v_z / speed;
  q.y = -reach * cosine - side * (q.R + q.r) * sine;
  q.z = -reach * sine + side * (q.R + q.r) * cosine;
  return q;
}

/// Any double, often zero or one of the extremes.
double any_double(Random& random) {
  if (whole(random, 0, 9) == 0) return 0.0;
  return std::ldexp(random.uniform(-1.0, 1.0), whole(random, -1073, 1024));
}

double above_zero(double value) { return value == 0.0 ? 5e-324 : std::abs(value); }

Query mixed(Random& random) {
  Query q{any_double(random),
          any_double(random),
          any_double(random),
          any_double(random),
          above_zero(any_double(random)),
          above_zero(any_double(random)),
          std::abs(any_double(random))};
  return q;
}

/// Lengths of one order, speeds of another, dt of a third: any of the double's whole range, but
/// that the times of impact are about dt.
Query any_order(Random& random) {
  const auto near = [&](int exponent) {
    return std::ldexp(random.uniform(-1.0, 1.0), exponent + whole(random, -3, 3));
  };
  const int length = whole(random, -1070, 1018);
  const int speed = whole(random, std::max(-1070, length - 1018), std::min(1018, length + 1070));
  return {near(length),
          near(length),
          near(speed),
          near(speed),
          above_zero(near(length - 2)),
          above_zero(near(length - 2)),
          std::abs(near(std::min(length - speed, 1018)))};
}

Query grazing(Random& random) {
  const double sign = coin(random) ? 1.0 : -1.0;
  return nudged(random, path(random, sign, random.uniform(0.1, 10.0), random.uniform(5.0, 15.0)));
}

Query far_grazing(Random& random) {
  const double length = power_of_ten(random, 2.0, 15.0);
  return nudged(random, path(random, 1.0, length, length * random.uniform(0.5, 2.0)));
}

Query parallel(Random& random) {
  Query q = path(random, 1.0, 0.0, 1.0);
  if (coin(random)) q = generic(random);
  q = nudged(random, q);
  q.v_y = 0.0;
  q.v_z = coin(random) ? 0.0 : -0.0;
  return q;
}

Query touching_start(Random& random) {
  Query q = path(random, random.uniform(-1.0, 1.0), 0.0, random.uniform(0.1, 10.0));
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  q.y = (q.R + q.r) * std::cos(angle);
  q.z = (q.R + q.r) * std::sin(angle);
  return nudged(random, q);
}

/// dt is the time of impact, or up to two doubles off.
Query arriving(Random& random) {
  const int kind = whole(random, 0, 3);
  Query q = kind == 0 ? far(random) : kind == 1 ? grazing(random) : generic(random);
  q.dt = 1e3;
  if (const auto exact = impact(q)) q.dt = static_cast<double>(exact->time);
  q.dt = std::abs(nudged(random, q.dt));
  return q;
}

struct Triple {
  double a, b, c;  ///< a² + b² = c²
};

Triple triple(Random& random) {
  const int m = whole(random, 2, 1000);
  const int n = whole(random, 1, m - 1);
  Triple sides{double(m * m - n * n), double(2 * m * n), double(m * m + n * n)};
  if (coin(random)) std::swap(sides.a, sides.b);
  if (coin(random)) sides.a = -sides.a;
  if (coin(random)) sides.b = -sides.b;
  return sides;
}

/// Three ties that hold exactly: a path that touches in passing, a start in touch, an arrival at
/// dt.
Query whole_tie(Random& random) {
  const auto [a, b, c] = triple(random);
  const double r = whole(random, 1, static_cast<int>(c) - 1);
  const double k = whole(random, 1, 1000);
  Query q{a + k * b, b - k * a, -b, a, c - r, r, k * (coin(random) ? 1.0 : 2.0)};
  const int kind = whole(random, 0, 2);
  const double v_y = whole(random, -1000, 1000);
  const double v_z = whole(random, -1000, 1000);
  if (kind == 1) q = {a, b, v_y, v_z, c - r, r, 1.0};
  if (kind == 2) q = {a - k * v_y, b - k * v_z, v_y, v_z, c - r, r, k};
  return q;
}

Query tie(Random& random, int lowest, int highest) {
  Query q = whole_tie(random);
  const int length = whole(random, lowest, highest);
  const int speed = whole(random, std::max(lowest, length - highest), highest);
  for (double* x : {&q.y, &q.z, &q.R, &q.r}) *x = std::ldexp(*x, length);
  for (double* v : {&q.v_y, &q.v_z}) *v = std::ldexp(*v, speed);
  q.dt = std::ldexp(q.dt, length - speed);
  return coin(random) ? q : nudged(random, q);
}

}  // namespace

std::vector<ImpactClass> impact_classes() {
  const auto ordinary_tie = [](Random& random) { return tie(random, -30, 30); };
  const auto tiny_tie = [](Random& random) { return tie(random, -1074, -1000); };
  const auto any_tie = [](Random& random) { return tie(random, -1074, 970); };
  return {
      {"generic", false, true, generic},           {"from 1e8 away", false, true, far},
      {"1e6 radii a step", false, true, fast},     {"tiny velocity", false, false, slow},
      {"any exponents", false, false, mixed},      {"any orders", false, false, any_order},
      {"grazing", true, false, grazing},           {"grazing from far", true, false, far_grazing},
      {"parallel", true, false, parallel},         {"start in touch", true, false, touching_start},
      {"arrival at dt", true, false, arriving},    {"Pythagorean ties", true, false, ordinary_tie},
      {"ties of any order", true, false, any_tie}, {"ties of subnormals", true, false, tiny_tie}};
}

}  // namespace tests
