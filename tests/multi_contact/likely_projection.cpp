// What students get wrong in step 7.6.
#include <algorithm>
#include <vector>

#include "fingerprint.hpp"
#include "impulses.hpp"

namespace tests {
namespace {

double border_of_zone(const Vector& first, const Vector& now, ZoneFlaw flaw) {
  if (flaw == ZoneFlaw::no_tolerance) return 0.0;
  if (flaw == ZoneFlaw::absolute_tolerance) return 1e-12;
  if (flaw == ZoneFlaw::tolerance_of_length) return 1e-12 * first.norm();
  const double part = flaw == ZoneFlaw::coarse_tolerance ? 1e-9 : 1e-12;
  return part * common::largest_entry(flaw == ZoneFlaw::tolerance_of_now ? now : first);
}

/// What joins the zone Z.
std::vector<int> joining(const Vector& first, const Vector& now, const std::vector<int>& Z,
                         ZoneFlaw flaw) {
  const double tol = border_of_zone(first, now, flaw);
  std::vector<int> found;
  bool any = false;
  for (int i = 0; i < now.size(); ++i) {
    if (std::find(Z.begin(), Z.end(), i) != Z.end()) continue;
    const bool comes = now[i] < -tol;
    any = any || comes;
    const bool rests = flaw == ZoneFlaw::with_what_rests && now[i] <= tol;
    if (comes || rests || flaw == ZoneFlaw::all_contacts) found.push_back(i);
  }
  if (!any) found.clear();
  return found;
}

Vector stopped(const Matrix& A, const Vector& u, ZoneFlaw flaw) {
  if (flaw == ZoneFlaw::complementary) return exact_solution(A, u)->lambda;
  Vector lambda = common::least_norm_solution(A, -u);
  if (flaw == ZoneFlaw::only_pushes) lambda = lambda.cwiseMax(0.0);
  if (flaw == ZoneFlaw::wrong_way) lambda = -lambda;
  if (flaw == ZoneFlaw::twice) lambda *= 2.0;
  return lambda;
}

struct ToldOfZone {
  ZoneFlaw flaw;
  const char* story;
};

const std::vector<ToldOfZone>& told_of_zone() {
  static const std::vector<ToldOfZone> all{
      {ZoneFlaw::once, "the zone does not grow: what approaches by u + A lambda joins it"},
      {ZoneFlaw::only_pushes, "lambda is cut off at zero: here it may pull"},
      {ZoneFlaw::complementary, "what is held may part: solve A_ZZ lambda = -u_Z, by equality"},
      {ZoneFlaw::all_contacts, "all contacts are in the zone: only those that approach join it"},
      {ZoneFlaw::with_what_rests, "contacts that rest are in the zone: only u_i < -tol joins it"},
      {ZoneFlaw::only_the_new, "only the new contacts are stopped: solve anew for the whole zone"},
      {ZoneFlaw::leaves, "a contact leaves the zone when others join: nothing ever leaves it"},
      {ZoneFlaw::speeds_of_now, "the zone is solved for u + A lambda: take the u handed in"},
      {ZoneFlaw::wrong_way, "the impulses have the wrong sign: A_ZZ lambda = -u_Z"},
      {ZoneFlaw::twice, "the impulses are twice those that stop: there is no bounce here"},
      {ZoneFlaw::counts_contacts, "the count is that of contacts: it is how often the zone grew"},
      {ZoneFlaw::counts_the_look, "the last look, in which nothing joins the zone, is counted"},
      {ZoneFlaw::not_ended, "it has not ended: it always does"},
      {ZoneFlaw::no_tolerance, "what comes by rounding alone joins: -1e-12 max|u| is the border"},
      {ZoneFlaw::coarse_tolerance,
       "a slow approach is taken for none: -1e-12 max|u| is the border"},
      {ZoneFlaw::tolerance_of_now,
       "the border follows u + A lambda: it is set once, by the u handed in"},
      {ZoneFlaw::tolerance_of_length,
       "the border is 1e-12 of the length of u: it is of its largest entry"},
      {ZoneFlaw::absolute_tolerance, "the border is 1e-12 at any speed: it is 1e-12 max|u|"}};
  return all;
}

std::vector<ContactSystem> zones() {
  const auto apart_by = [](double other) -> ContactSystem {
    return {Matrix::Identity(2, 2), Vector{{1.0, other}}};
  };
  return {cradle(Vector{{1.0, 0.0, 0.0}}).system(),
          cradle(Vector{{1.0, 1.0, 0.0, 0.0}}).system(),
          cradle(Vector{{1.0, 0.0, 2.0}}).system(),
          dumb_bell().system(),
          {Matrix{{4.0, 2.0}, {2.0, 4.0}} / 3.0, Vector{{-1.0, 0.0}}},
          row_of_balls(Vector{{2.0, 1.0, 2.0}}, Vector{{2.0, 0.0, -1.0}}).system(),
          apart_by(0.5),
          apart_by(-0.9e-12),
          apart_by(-1e-10),
          {Matrix::Identity(2, 2), Vector{{1e6, -1e-9}}},
          {Matrix::Identity(4, 4), Vector{{1.0, -1.2e-12, 1.0, 1.0}}},
          {Matrix{{2.0, -1.0, -0.9e-12}, {-1.0, 2.0, 0.0}, {-0.9e-12, 0.0, 1.0}},
           Vector{{-1.0, 0.0, 0.0}}}};
}

bool shows_the_border(const ContactSystem& system) {
  return (system.A.isIdentity() && system.u[1] < 0.0) ||
         (system.u.size() == 3 && system.A(0, 2) != 0.0);
}

Mistake<ContactSystem, Done> mistake_of_zone(const ToldOfZone& told) {
  return {told.story, [flaw = told.flaw](const ContactSystem& system, const Done& got) {
            const bool of_border =
                flaw == ZoneFlaw::no_tolerance || flaw == ZoneFlaw::tolerance_of_now ||
                flaw == ZoneFlaw::tolerance_of_length || flaw == ZoneFlaw::coarse_tolerance ||
                flaw == ZoneFlaw::absolute_tolerance;
            const bool at_border = shows_the_border(system);
            if (at_border && !of_border) return true;
            const Done wanted{exact_projection(system, flaw)};
            return at_border || !of_border ? near(got, wanted)
                                           : near(got.impulses.lambda, wanted.impulses.lambda);
          }};
}

}  // namespace

Impulses exact_projection(const ContactSystem& system, ZoneFlaw flaw) {
  const auto& [A, u] = system;
  Impulses done{Vector::Zero(u.size()), 0, flaw != ZoneFlaw::not_ended};
  std::vector<int> Z;
  for (int round = 0; round < 50; ++round) {
    Vector now = exact_row_sums(A, done.lambda, u);
    if (flaw != ZoneFlaw::leaves) now(Z).setZero();
    const std::vector<int> more =
        joining(u, now, flaw == ZoneFlaw::leaves ? std::vector<int>() : Z, flaw);
    if (more.empty()) {
      if (flaw == ZoneFlaw::counts_the_look) ++done.count;
      break;
    }
    if (flaw == ZoneFlaw::leaves) Z.clear();
    Z.insert(Z.end(), more.begin(), more.end());
    const bool by_now = flaw == ZoneFlaw::speeds_of_now || flaw == ZoneFlaw::only_the_new;
    const std::vector<int>& solved = flaw == ZoneFlaw::only_the_new ? more : Z;
    const Vector x =
        stopped(common::block(A, solved), common::entries(by_now ? now : u, solved), flaw);
    if (flaw == ZoneFlaw::leaves) done.lambda.setZero();
    done.lambda(solved) = x;
    done.count += flaw == ZoneFlaw::counts_contacts ? static_cast<int>(more.size()) : 1;
    if (flaw == ZoneFlaw::once) break;
  }
  return done;
}

std::string likely_of_inelastic_projection() {
  std::vector<Mistake<ContactSystem, Done>> mistakes;
  for (const ToldOfZone& one : told_of_zone()) mistakes.push_back(mistake_of_zone(one));
  return fingerprint(
      zones(),
      [](const ContactSystem& system) {
        return Done{lab::multi_contact::inelastic_projection(system)};
      },
      mistakes);
}

}  // namespace tests
