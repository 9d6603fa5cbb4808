// What students get wrong in step 7.3.
#include "fingerprint.hpp"
#include "sweeps.hpp"

namespace tests {
namespace {

/// The dumb-bell, a column and one sweep, two, three and none, also from below zero.
std::vector<SweepsInput> sweeps_inputs() {
  const Matrix dumb_bell = Matrix{{4.0, 2.0}, {2.0, 4.0}} / 3.0;
  const Matrix column{{1.0, -1.0, 0.0}, {-1.0, 2.5, -1.0}, {0.0, -1.0, 2.0}};
  const Vector slow_first{{-0.5, -2.0}};
  const Vector fall{{-1.0, -0.5, 0.25}};
  return {{dumb_bell, slow_first, Vector::Zero(2), 1},
          {dumb_bell, slow_first, Vector::Zero(2), 3},
          {dumb_bell, Vector{{-2.0, -0.5}}, Vector{{1.0, 1.0}}, 2},
          {column, fall, Vector{{0.5, -1.0, 2.0}}, 1},
          {column, fall, Vector{{0.5, -1.0, 2.0}}, 2},
          {column, fall, Vector{{0.5, 1.0, 2.0}}, 3},
          {column, fall, Vector{{0.5, -1.0, 2.0}}, 0}};
}

struct ResidualInput {
  Matrix A;
  Vector b;
  Vector lambda;
};

std::vector<ResidualInput> residual_inputs() {
  const Matrix apart{{2.0, 0.0}, {0.0, 4.0}};
  return {{apart, Vector{{-8.0, 1.0}}, Vector{{5.0, 0.25}}},
          {apart, Vector{{4.0, 1.0}}, Vector{{-0.5, 0.125}}},
          {apart, Vector{{-1.0, 1.0}}, Vector{{-3.0, 0.5}}},
          {apart, Vector{{-1.0, -2.0}}, Vector{{0.25, 0.75}}},
          {Matrix{{2.0, -1.0}, {-1.0, 2.0}}, Vector{{-1.0, 0.5}}, Vector{{0.25, 0.125}}},
          {apart, Vector{{6.0, 4.0}}, Vector{{0.5, 0.0}}}};
}

}  // namespace

std::string likely_of_gauss_seidel() {
  std::vector<Mistake<SweepsInput, Vector>> all;
  for (const auto& [flaw, story] : sweeps_flaws()) {
    all.push_back(returns<SweepsInput, Vector>(
        story, [f = flaw](const SweepsInput& in) { return lambda_after(in, f); }));
  }
  return fingerprint(
      sweeps_inputs(),
      [](const SweepsInput& in) {
        return lab::multi_contact::gauss_seidel(in.A, in.b, in.start, in.sweeps);
      },
      all);
}

std::string likely_of_residual() {
  std::vector<Mistake<ResidualInput, double>> all;
  for (const auto& [flaw, story] : residual_flaws()) {
    all.push_back(returns<ResidualInput, double>(story, [f = flaw](const ResidualInput& in) {
      return residual_of(in.A, in.b, in.lambda, f);
    }));
  }
  return fingerprint(
      residual_inputs(),
      [](const ResidualInput& in) { return lab::multi_contact::residual(in.A, in.b, in.lambda); },
      all);
}

}  // namespace tests
