// These charts show culling against computing time, for meshes of a thousand to a million
// triangles: the number of triangle tests for each pair that meets, and the time of a query. With
// --mesh FILE.obj they show the same for that mesh, or for two.
#include <map>

#include "chart_trees.hpp"
#include "own_meshes.hpp"
#include "render/chart/chart_program.hpp"

using namespace lab::bvh_traversal;
namespace palette = render::palette;

namespace {

/// Shapes of any size, and their triangles that meet. Each is made when it is first needed.
class Problem {
 public:
  explicit Problem(std::function<ShapePair(std::size_t)> make) : make_(std::move(make)) {}

  const ShapePair& shapes(double triangles) {
    const auto [place, is_new] = shapes_.try_emplace(triangles);
    if (is_new) place->second = make_(static_cast<std::size_t>(triangles));
    return place->second;
  }
  /// Finds them by a tree that only one method here uses.
  const std::vector<TrianglePair>& pairs(double triangles) {
    const auto [place, is_new] = pairs_.try_emplace(triangles);
    if (is_new) place->second = by_eights(shapes(triangles))().pairs;
    return place->second;
  }

 private:
  std::function<ShapePair(std::size_t)> make_;
  std::map<double, ShapePair> shapes_;
  std::map<double, std::vector<TrianglePair>> pairs_;
};

using SharedProblem = std::shared_ptr<Problem>;

/// Trees that are built at the first query, and kept.
class Trees {
 public:
  Trees(SharedProblem problem, Build build)
      : problem_(std::move(problem)), build_(std::move(build)) {}

  const Ask& at(double triangles) {
    Ask& ask = asks_[triangles];
    if (!ask) ask = build_(problem_->shapes(triangles));
    return ask;
  }

 private:
  SharedProblem problem_;
  Build build_;
  std::map<double, Ask> asks_;
};

render::Method method(const std::string& name, render::Colour colour, const SharedProblem& problem,
                      const std::vector<double>& sizes, const Build& build) {
  const auto trees = std::make_shared<Trees>(problem, build);
  render::Method result{name, 0.0, colour, sizes, nullptr, nullptr};
  result.judge = [=](double triangles) {
    Intersections found = trees->at(triangles)();
    std::sort(found.pairs.begin(), found.pairs.end());
    const std::vector<TrianglePair>& exact = problem->pairs(triangles);
    const auto tests = static_cast<double>(found.triangle_tests);
    // If nothing meets, the tests are counted for each triangle.
    const double by = exact.empty()
                          ? static_cast<double>(problem->shapes(triangles).a.triangles.size())
                          : static_cast<double>(exact.size());
    return render::Judgement{tests / by, static_cast<double>(found.box_tests),
                             found.pairs == exact};
  };
  result.prepare = [=](double triangles) { trees->at(triangles); };
  result.run = [=](double triangles) {
    volatile std::size_t kept = trees->at(triangles)().pairs.size();
    static_cast<void>(kept);
  };
  return result;
}

const std::vector<double> sizes = render::ladder(1000, 1000000, 10);
/// For large leaves: an answer that tests all their pairs of triangles takes seconds for a million.
const std::vector<double> sizes_of_large_leaves = render::ladder(1000, 100000, 10);

std::vector<render::Method> methods(const SharedProblem& problem) {
  std::vector<render::Method> all{
      method("halves, leaves of 64", palette::orange, problem, sizes_of_large_leaves,
             by_halves(64)),
      method("heuristic, leaves of 1", palette::purple, problem, sizes, by_sah(1)),
      method("heuristic, leaves of 8", palette::sky, problem, sizes, by_sah(8)),
      method("heuristic, leaves of 64", palette::blue, problem, sizes_of_large_leaves, by_sah(64)),
      method("eight-fold nodes", palette::green, problem, sizes, by_eights)};
  all[1].shows_parameters = true;
  return all;
}

render::MeasuredChart chart(const char* name, const char* title, const char* subtitle,
                            const std::vector<render::Method>& methods) {
  render::Chart chart;
  chart.name = name;
  chart.lab = "5_bvh_traversal";
  chart.title = title;
  chart.subtitle = subtitle;
  chart.error_name = "triangle tests";
  chart.error_unit = "per meeting pair";
  chart.work_unit = "query";
  chart.parameter_name = "triangles of each";
  return {chart, methods};
}

render::ChartPlan full_plan(bool with_peers) {
  const auto at_rest = std::make_shared<Problem>(tori);
  const auto turned_spheres = std::make_shared<Problem>([](std::size_t triangles) {
    ShapePair shapes = spheres(triangles);
    shapes.a_from_b = turned();
    return shapes;
  });
  const auto apart = std::make_shared<Problem>(shells);

  std::vector<render::Method> of_tori = methods(at_rest);
  of_tori.insert(
      of_tori.begin(),
      {method("brute force", palette::ink, at_rest, {100, 300, 1000, 3000}, brute_force),
       method("as first written", palette::vermilion, at_rest, sizes, as_first_written)});
  of_tori.push_back(method("heuristic, boxes in floats", palette::grey, at_rest,
                           sizes_of_large_leaves, in_float_boxes));
  render::ChartPlan plan;
  plan.charts = {
      chart("chart", "Two tori that meet: culling against computing time",
            "1k to 1M triangles each, leaves of 64 to 100k, brute force 100 to 3k; a cross: pairs "
            "are lost",
            of_tori),
      chart("turned", "Two spheres that meet, one turned: culling against computing time",
            "1k to 1M triangles each, leaves of 64 to 100k; a new pose, but no new tree (Embree "
            "rebuilds its own)",
            methods(turned_spheres)),
      chart("shells", "A sphere around another: a hard case for boxes",
            "none meet, but boxes along the axes do not see a gap of 0.3 edges: work grows as n; "
            "1k to 1M, leaves of 64 to 100k",
            methods(apart))};
  plan.charts.back().chart.error_unit = "per triangle";
  if (!with_peers) return plan;
  const std::vector<SharedProblem> problems{at_rest, turned_spheres, apart};
  for (const Peer& peer : peers()) {
    if (!peer.make) {
      plan.left_out.push_back(left_out(peer));
      continue;
    }
    for (std::size_t i = 0; i < problems.size(); ++i) {
      render::Method peers_method = method(peer.name, {}, problems[i], sizes, by_peer(peer));
      peers_method.is_peer = true;
      plan.charts[i].methods.push_back(std::move(peers_method));
    }
  }
  return plan;
}

/// Returns the plan for the user's own mesh and another, or the same again, turned and shifted.
render::ChartPlan plan_of(const OwnMeshes& own) {
  ShapePair shapes{own.fitted(0, 1.0), own.fitted(1, 1.0), turned()};
  const auto size = static_cast<double>(shapes.a.triangles.size());
  const auto problem = std::make_shared<Problem>([shapes](std::size_t) { return shapes; });
  std::vector<render::Method> all = methods(problem);
  for (render::Method& method : all) method.parameters = {size};
  if (size * static_cast<double>(shapes.b.triangles.size()) <= 1e7) {
    all.insert(all.begin(), method("brute force", palette::ink, problem, {size}, brute_force));
  }
  char subtitle[120];
  std::snprintf(subtitle, sizeof subtitle,
                "%zu and %zu triangles, the second turned; each tree is built once",
                shapes.a.triangles.size(), shapes.b.triangles.size());
  render::ChartPlan plan;
  plan.charts = {chart("mesh", "", subtitle, all)};
  plan.charts[0].chart.title = own.name(0) + " and " + own.name(1) + ": culling against time";
  return plan;
}

/// Returns the plan. A brief one leaves out the trees of a million triangles, because they take
/// seconds to build.
render::ChartPlan plan(const render::ChartRequest& request) {
  render::ChartPlan plan = full_plan(request.peers);
  if (request.extent == render::Extent::full) return plan;
  for (render::MeasuredChart& part : plan.charts) {
    for (render::Method& method : part.methods) {
      std::erase_if(method.parameters, [](double triangles) { return triangles > 100000.0; });
    }
  }
  return plan;
}

}  // namespace

int main(int argc, char** argv) {
  OwnMeshes own;
  own.take_from(argc, argv);
  return render::chart_main(argc, argv, [&](const render::ChartRequest& request) {
    return own.files.empty() ? plan(request) : plan_of(own);
  });
}
