#include "bad_input.hpp"
#include "catch.hpp"

using namespace lab::continuous_particle_cylinder;
using tests::Digits100;
using tests::eps;
using tests::Query;
using tests::Trial;

namespace {

const std::string contact_step = "4.4 contact_at";

Trial contact_trial(const Query& query, double time, int index = 1, int count = 1) {
  return Trial(contact_step, index, count)
      .given("particle.position", query.particle.position)
      .given("particle.velocity", query.particle.velocity)
      .given("particle.radius", query.particle.radius)
      .given("cylinder.radius", query.cylinder.radius)
      .given("time", time);
}

/// The contact of a ball of radius r at a place, in 100 digits.
ParticleContact exact_contact(const Query& query, double time) {
  const auto at = [&](int i) {
    return Digits100(query.particle.position[i]) + Digits100(time) * query.particle.velocity[i];
  };
  const Digits100 distance = sqrt(at(1) * at(1) + at(2) * at(2));
  const Digits100 ny = distance == 0 ? Digits100(1) : Digits100(at(1) / distance);
  const Digits100 nz = distance == 0 ? Digits100(0) : Digits100(at(2) / distance);
  const double R = query.cylinder.radius;
  const double r = query.particle.radius;
  const auto vector = [](const Digits100& x, const Digits100& y, const Digits100& z) {
    return Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
  };
  ParticleContact contact;
  contact.normal = vector(0, ny, nz);
  contact.point_on_cylinder = vector(at(0), R * ny, R * nz);
  contact.point_on_particle = vector(at(0), at(1) - r * ny, at(2) - r * nz);
  contact.gap = static_cast<double>(Digits100(distance - R - r));
  contact.time = time;
  return contact;
}

using Suspects = std::vector<tests::Suspect<Vec3>>;

const std::string says_start =
    "the contact is that of the start: the particle is not moved to x + t v";
const std::string says_reversed =
    "the normal is reversed: let it point from the cylinder to the particle";
const std::string says_middle = "this is the particle's centre: the point is r nearer to the axis";
const std::string says_spatial = "x is kept in the normal: set its x to 0";
const std::string says_start_normal = "the normal is that of the start: take it at x + t v";
const std::string says_same_x =
    "the particle's own motion along x is left out: use the x of x + t v";
const std::string says_swapped =
    "the two points are swapped: the one on the cylinder is R n, that on the particle p - r n";

/// Returns a story if the normal is not finite on the axis, but right off it.
std::string nan_on_axis() {
  const Cylinder cylinder{4.0};
  const Vec3 off_axis = contact_at({{0, 3, 0}, {0, 0, 0}, 1.0}, cylinder, 0.0).normal;
  const Vec3 on_axis = contact_at({{0, 0, 0}, {0, 0, 0}, 1.0}, cylinder, 0.0).normal;
  const bool is_right_off_axis = tests::difference(off_axis, Vec3(0, 1, 0)) <= 4.0 * eps;
  return is_right_off_axis && !tests::is_finite(on_axis)
             ? "0 is divided by 0 on the axis: there the normal is +y"
             : "";
}

Suspects suspects_on_axis(const Query& query) {
  const Vec3& v = query.particle.velocity;
  const Vec3 against(0, -v.y(), -v.z());
  Suspects suspects{{Vec3::Zero(), "the normal on the axis is left at zero: there it is +y"},
                    {Vec3(0, 0, 1), "the normal on the axis is +z: the contract says +y"},
                    {Vec3(1, 0, 0), "the normal on the axis is +x: the contract says +y"},
                    {Vec3(0, -1, 0), says_reversed}};
  if (against.norm() > 0.0) {
    suspects.push_back({Vec3(against.normalized()),
                        "the normal is -v made unit: it points from the axis to the particle"});
  }
  return suspects;
}

/// What a contact is judged by.
struct ContactInput {
  Query query;
  double time;
  ParticleContact wanted, at_start, got;
  Vec3 center, radial;
  double place, along, distance, turn;  ///< bounds of roundings
};

ContactInput contact_input(const Query& query, double time) {
  ContactInput in{
      query, time, exact_contact(query, time), exact_contact(query, 0.0), {}, {}, {}, 0.0, 0.0,
      0.0,   0.0};
  const Vec3& x = query.particle.position;
  const Vec3& v = query.particle.velocity;
  in.got = contact_at(query.particle, query.cylinder, time);
  in.center = in.wanted.point_on_particle + query.particle.radius * in.wanted.normal;
  in.radial = {0.0, in.center.y(), in.center.z()};
  // t v and x + t v are rounded: half an eps of each, and a few more for what is made of them.
  in.place = 4.0 * eps * (std::hypot(x.y(), x.z()) + time * std::hypot(v.y(), v.z()));
  in.along = 2.0 * eps * (std::abs(x.x()) + time * std::abs(v.x()));
  in.distance = in.radial.norm();
  in.turn = std::min(2.0, (in.distance > 0.0 ? in.place / in.distance : 0.0) + 8.0 * eps);
  return in;
}

double gap_bound(const ContactInput& in) { return in.place + 4.0 * eps * tests::rho(in.query); }

Suspects suspects_of_normal(const ContactInput& in) {
  if (in.distance == 0.0) return suspects_on_axis(in.query);
  const Vec3& v = in.query.particle.velocity;
  const Vec3 course(0.0, v.y(), v.z());
  const bool is_moved = std::abs(in.got.gap - in.wanted.gap) <= gap_bound(in);
  return {{-in.wanted.normal, says_reversed},
          {in.at_start.normal, is_moved ? says_start_normal : says_start},
          {Vec3(-course.normalized()),
           "the normal is -v made unit: it points from the axis to the particle"},
          {Vec3(course.normalized()),
           "the normal is v made unit: it points from the axis to the particle"},
          {Vec3(in.radial / tests::rho(in.query)),
           "the normal is divided by R + r: divide it by the distance from the axis"},
          {in.radial, "the normal is not made unit: divide it by its length"},
          {Vec3(in.center.normalized()), says_spatial}};
}

Suspects suspects_of_point_on_cylinder(const ContactInput& in) {
  const Vec3& n = in.wanted.normal;
  const double R = in.query.cylinder.radius;
  const bool is_swapped =
      tests::difference(in.got.point_on_particle, in.wanted.point_on_cylinder) <=
      2.0 * (R * in.turn + in.along);
  return {{in.at_start.point_on_cylinder, says_start},
          {Vec3(in.query.particle.position.x(), R * n.y(), R * n.z()), says_same_x},
          {in.wanted.point_on_particle,
           is_swapped ? says_swapped
                      : "this is p - r n, the point on the particle: the one on the cylinder is "
                        "R n"},
          {Vec3(in.center - 2.0 * in.radial + (in.distance - R) * n), says_reversed},
          {Vec3(in.center - in.radial + tests::rho(in.query) * n),
           "this is R + r from the axis: the cylinder ends at R"},
          {Vec3(R * n), "x is lost: use the particle's x"}};
}

Suspects suspects_of_point_on_particle(const ContactInput& in) {
  const Vec3& wanted = in.wanted.point_on_particle;
  return {{in.at_start.point_on_particle, says_start},
          {in.center, says_middle},
          {Vec3(in.query.particle.position.x(), wanted.y(), wanted.z()), says_same_x},
          {in.wanted.point_on_cylinder,
           "this is the point on the cylinder: the one on the particle is p - r n"},
          {Vec3(in.center + in.query.particle.radius * in.wanted.normal),
           "this is the far side of the particle: subtract r n from its centre"}};
}

std::vector<tests::Suspect<double>> suspects_of_gap(const ContactInput& in) {
  const double rho = tests::rho(in.query);
  return {{in.at_start.gap, says_start},
          {in.wanted.gap + in.query.particle.radius,
           "the particle's radius is forgotten: use R + r, not R"},
          {in.center.norm() - rho, "x is kept in the gap: use only y and z"},
          {in.radial.squaredNorm() - rho * rho,
           "the gap is a difference of squares: subtract R + r from the distance itself"},
          {0.0, "the gap is left at zero: it is the distance from the axis, less R + r"},
          {-in.wanted.gap, "the gap has the wrong sign: it is above zero outside"}};
}

void expect_contact(const Query& query, double time, int index, int count) {
  const ContactInput in = contact_input(query, time);
  const ParticleContact& got = in.got;
  const ParticleContact& wanted = in.wanted;
  const Trial here = contact_trial(query, time, index, count).suspecting(nan_on_axis);
  here.of("the normal")
      .expect(got.normal, wanted.normal,
              {in.turn, "the rounding of x + t v, divided by its distance"},
              [&] { return suspects_of_normal(in); });
  here.of("the point on the cylinder")
      .expect(got.point_on_cylinder, wanted.point_on_cylinder,
              {query.cylinder.radius * in.turn + in.along, "R times the rounding of the normal"},
              [&] { return suspects_of_point_on_cylinder(in); });
  here.of("the point on the particle")
      .expect(got.point_on_particle, wanted.point_on_particle,
              {in.place + query.particle.radius * in.turn + in.along,
               "the rounding of x + t v, and r times that of the normal"},
              [&] { return suspects_of_point_on_particle(in); });
  here.of("the gap").expect(got.gap, wanted.gap,
                            {gap_bound(in), "the rounding of x + t v and of R + r"},
                            [&] { return suspects_of_gap(in); });
  here.of("the time")
      .expect(got.time, time, {0.0, "the time that was passed in"},
              {{0.0, "the time of the contact is not set: set it"}});
}

}  // namespace

TEST_CASE("A contact on a 3-4-5 triangle has whole numbers", "[4.4]") {
  const Query query = tests::query({1, 10, 3}, {2, -2, 0}, 10.0);
  expect_contact(query, 1.0, 1, 3);  // before: apart
  expect_contact(query, 4.0, 2, 3);  // after: inside
  expect_contact(query, 3.0, 3, 3);
  const ParticleContact got = contact_at(query.particle, query.cylinder, 3.0);
  const Trial here = contact_trial(query, 3.0);
  here.of("the normal").expect(got.normal, Vec3(0, 0.8, 0.6), {4.0 * eps, "4/5 and 3/5"});
  here.of("the point on the cylinder")
      .expect(got.point_on_cylinder, Vec3(7, 3.2, 2.4), {16.0 * eps, "4/5 of the centre"});
  here.of("the point on the particle")
      .expect(got.point_on_particle, Vec3(7, 3.2, 2.4), {16.0 * eps, "they touch"});
  here.of("the gap").expect(got.gap, 0.0, {8.0 * eps, "5 - (4 + 1)"});
}

TEST_CASE("A contact agrees with a hundred digits at any place", "[4.4]") {
  tests::Random random(441);
  for (int i = 1; i <= 200; ++i) {
    const Query query = tests::generic_query(random);
    expect_contact(query, random.uniform(0.0, query.dt), i, 200);
  }
}

TEST_CASE("At the time of impact the normal is unit and the point on the surface", "[4.4]") {
  tests::Random random(442);
  for (int i = 1; i <= 200; ++i) {
    const double distance = tests::power_of_ten(random, 0.1, 6.0);
    Query query = tests::aimed(random, {distance, random.uniform(-0.9, 0.9), 1.0});
    query.particle.position.x() = random.uniform(-1e8, 1e8);
    const double time = tests::nudged(random, *tests::time_of(query).seconds, 4);
    const ParticleContact got = contact_at(query.particle, query.cylinder, time);
    const double R = query.cylinder.radius;
    const Trial here = contact_trial(query, time, i, 200);
    here.expect_small("||n| - 1|", std::abs(got.normal.norm() - 1.0), {4.0 * eps, "unit"});
    here.expect_small("|n.x|", std::abs(got.normal.x()), {0.0, "the normal lies in the yz-plane"},
                      "x is kept in the normal: set its x to 0");
    const Vec3& p = got.point_on_cylinder;
    here.expect_small("distance of the point from the surface",
                      std::abs(std::hypot(p.y(), p.z()) - R),
                      {4.0 * eps * R, "R times a unit vector, at any x"});
    expect_contact(query, time, i, 200);
  }
}

TEST_CASE("On the axis the normal is plus y", "[4.4]") {
  expect_contact(tests::query({7, 0, 0}, {0, 0, 0}, 1.0), 0.5, 1, 4);
  expect_contact(tests::query({7, 2, 0}, {3, -1, 0}, 1.0), 2.0, 2, 4);
  expect_contact(tests::query({7, 1, -2}, {3, -0.5, 1}, 1.0), 2.0, 3, 4);
  expect_contact(tests::query({7, -0.0, -0.0}, {0, -0.0, -0.0}, 1.0), 0.5, 4, 4);
}

TEST_CASE("Next to the axis and at every scale the normal is unit", "[4.4]") {
  // Squares under- and overflow here.
  tests::Random random(443);
  for (int i = 1; i <= 100; ++i) {
    Query query = tests::generic_query(random);
    query.particle.velocity.setZero();
    const double size = tests::power_of_ten(random, -290.0, 290.0);
    query.particle.position *= size;
    if (i % 2 == 0) query.particle.radius *= size;
    if (i % 2 == 0) query.cylinder.radius *= size;
    const ParticleContact got = contact_at(query.particle, query.cylinder, 0.0);
    contact_trial(query, 0.0, i, 100)
        .of("the normal")
        .expect(got.normal, exact_contact(query, 0.0).normal, {8.0 * eps, "a quotient by a hypot"});
  }
}

TEST_CASE("A contact refuses bad arguments", "[4.4]") {
  for (const auto& [why, query] : tests::bad_queries()) {
    if (query.dt == 1.0) {
      contact_trial(query, 1.0)
          .expect_throw(
              [&, &query = query] {
                return contact_at(query.particle, query.cylinder, 1.0).normal;
              },
              why, "the arguments are not checked: throw std::invalid_argument for a bad one");
    }
  }
  const Query query = tests::query({0, 10, 20}, {0, -1, 0}, 1.0);
  for (const double time : {tests::infinity, std::numeric_limits<double>::quiet_NaN()}) {
    contact_trial(query, time)
        .expect_throw([&] { return contact_at(query.particle, query.cylinder, time).normal; },
                      "the time is not finite",
                      "the arguments are not checked: throw std::invalid_argument for a bad one");
  }
}
