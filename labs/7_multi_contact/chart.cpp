// Speed left against computing time, for columns and a box full of balls that fall at once; how
// many impulses an impact takes; and where a block slides that is held by a box or a diamond.
#include <cmath>

#include "chart_histories.hpp"
#include "chart_solvers.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::multi_contact;
namespace {

render::Method method(const std::string& name, render::Colour colour, const SharedProblem& problem,
                      const std::vector<double>& counts, const Solver& solver) {
  render::Method result{name, 0.0, colour, counts, nullptr, nullptr};
  result.judge = [=](double count) {
    const double error = problem->error(solver(problem->system(), static_cast<int>(count)));
    const bool is_known = std::isfinite(error);
    return render::Judgement{is_known ? error : 1.0, count, is_known};
  };
  result.run = [=](double count) {
    volatile double kept = solver(problem->system(), static_cast<int>(count)).sum();
    static_cast<void>(kept);
  };
  return result;
}

/// What theory says of the sweeps: a rate, for the time that they take.
render::Method theory(const char* name, const SharedProblem& problem,
                      const std::vector<double>& counts, double rate) {
  render::Method result = method(name, {}, problem, counts, by_gauss_seidel);
  result.judge = [=](double sweeps) {
    return render::Judgement{std::pow(rate, sweeps), sweeps, true};
  };
  std::erase_if(result.parameters, [=](double sweeps) { return std::pow(rate, sweeps) < 1e-13; });
  result.is_peer = true;
  return result;
}

/// The ladders' last rungs.
struct Longest {
  int sweeps;
  int jacobi_sweeps;
  int steps;
};

std::vector<render::Method> methods(const SharedProblem& problem, const Longest& longest) {
  return {method("Jacobi, half steps", palette::orange, problem,
                 render::ladder(1, longest.jacobi_sweeps), by_jacobi),
          method("Gauss-Seidel", palette::vermilion, problem, render::ladder(1, longest.sweeps),
                 by_gauss_seidel),
          method("accelerated", palette::blue, problem, render::ladder(1, longest.steps),
                 by_acceleration),
          method("active set, supplied", palette::green, problem, {1.0}, by_active_set)};
}

render::Method peer_method(const Peer& peer, const Falling& falling) {
  PeerBalls balls{radius, {}, {}, falling.walls};
  for (std::size_t i = 1; i < falling.bodies.size(); ++i) {
    balls.centers.push_back(falling.bodies[i].position);
    balls.velocities.push_back(falling.bodies[i].velocity);
  }
  const std::shared_ptr<PeerWorld> world = peer.make(balls);
  const double own = peer.iterations;
  render::Method result{peer.name + ", from its " + std::to_string(peer.iterations),
                        0.0,
                        {},
                        {own, 10.0 * own, 100.0 * own},
                        nullptr,
                        nullptr};
  result.run = [=](double iterations) { world->step(static_cast<int>(iterations)); };
  result.judge = [=](double iterations) {
    world->step(static_cast<int>(iterations));
    return render::Judgement{speed_left(world->velocities()), iterations, true};
  };
  result.is_peer = true;
  return result;
}

render::MeasuredChart solver_chart(const char* name, const std::string& title,
                                   const std::string& subtitle,
                                   const std::vector<render::Method>& methods) {
  render::Chart words;
  words.name = name;
  words.lab = lab_name;
  words.title = title;
  words.subtitle = subtitle;
  words.error_name = "speed left";
  words.error_unit = "of the fall";
  words.work_unit = "solution";
  words.parameter_name = "sweeps or steps";
  words.rounding_floor = 2.2e-16;
  return {words, methods};
}

render::MeasuredChart column_chart(const char* name, const SharedProblem& problem,
                                   const char* title, const Longest& longest) {
  const auto balls = static_cast<double>(problem->falling().bodies.size() - 1);
  const double cosine = std::cos(0.5 * std::numbers::pi / balls);
  std::vector<render::Method> all = methods(problem, longest);
  all.push_back(
      theory("cos²(π/2N) a sweep", problem, render::ladder(1, longest.sweeps), cosine * cosine));
  return solver_chart(
      name, title,
      "e = 0, all comes to rest; 1 sweep or step, 2, 4 …; root mean square; dashed: theory", all);
}

render::MeasuredChart box_chart(const SharedProblem& problem) {
  const std::string balls = std::to_string(problem->falling().bodies.size() - 1);
  const std::string contacts = std::to_string(problem->falling().contacts.size());
  return solver_chart("chart", balls + " balls in a box fall at once: what is left of their speed",
                      contacts +
                          " contacts, e = 0, all comes to rest; 1 sweep or step, 2, 4 …; "
                          "root mean square",
                      methods(problem, {1024, 4096, 2048}));
}

/// In a brief one a box of 400 balls would show next to nothing.
render::ChartPlan plan(const render::ChartRequest& request) {
  const int side = request.extent == render::Extent::brief ? 8 : 20;
  const auto box = std::make_shared<Problem>(box_of_balls(side));
  const auto low = std::make_shared<Problem>(column(10));
  const auto tall = std::make_shared<Problem>(column(100));
  render::ChartPlan plan;
  plan.charts = {
      box_chart(box),
      column_chart("column", low, "A column of 10 falls at once: what is left of its speed",
                   {1024, 4096, 512}),
      column_chart("tall_column", tall, "A column of 100 falls at once: what is left of its speed",
                   {65536, 131072, 8192})};
  plan.histories = {collapse_chart(), pi_chart(), slide_chart()};
  if (!request.peers) return plan;
  const std::vector<SharedProblem> problems{box, low, tall};
  for (const Peer& peer : peers()) {
    if (!peer.make) {
      plan.left_out.push_back(left_out(peer));
      continue;
    }
    for (std::size_t i = 0; i < problems.size(); ++i) {
      plan.charts[i].methods.push_back(peer_method(peer, problems[i]->falling()));
    }
  }
  return plan;
}

}  // namespace

int main(int argc, char** argv) { return render::chart_main(argc, argv, plan); }
