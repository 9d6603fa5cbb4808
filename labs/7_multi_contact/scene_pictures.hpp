#pragma once

#include <string>

#include "render/scene.hpp"
#include "scene_break.hpp"
#include "scene_cradle.hpp"
#include "scene_pile.hpp"

/// How the motions look: an eye on +x sees them in the y-z plane.
namespace lab::multi_contact {

namespace palette = render::palette;

inline constexpr double ground_height = -1.5;
inline const Vec3 towards_eye(2.2, 0.0, 0.4);

/// Of a model, in every picture.
inline render::Colour colour_of(std::size_t model) {
  constexpr std::array colours{palette::orange, palette::sky, palette::green};
  return colours.at(model);
}

inline render::Paint paint_of(const render::Colour& colour, float paleness = 0.0F) {
  return {colour, colour, paleness};
}

inline void add_ball(render::Scene& scene, const Vec3& place, double radius,
                     const render::Paint& paint) {
  scene.spheres.push_back({{place, Mat3::Identity()}, radius, paint});
}

inline void add_rod(render::Scene& scene, const Vec3& from, const Vec3& to, double radius) {
  scene.capsules.push_back({{0.5 * (from + to), render::z_axis_towards(to - from)},
                            radius,
                            0.5 * (to - from).norm(),
                            paint_of(palette::grey)});
}

/// A model's name, and smaller lines below it.
inline void add_words(render::Scene& scene, const Vec3& place, const Model& model,
                      const std::vector<std::string>& lines) {
  Vec3 next = place;
  const auto add = [&](const std::string& text, double size) {
    scene.labels.push_back({next, text, palette::ink, size});
    next.z() -= 0.2;
  };
  for (const char* const word : model.name) add(word, 22.0);
  for (const std::string& line : lines) add(line, 18.0);
}

inline constexpr double bar_depth = 0.13;  // from the plane of the balls to either bar
inline constexpr double bar_left = -0.1;
inline constexpr double bar_right = 2.1;

inline double bar_height(std::size_t model) { return 2.1 - 1.2 * static_cast<double>(model); }

/// A cradle on its bars; balls that swing are coloured, balls at rest are grey.
inline void add_cradle(render::Scene& scene, const Cradle& cradle, std::size_t model, double time) {
  const double first = 0.5 * (bar_left + bar_right) - cradle_radius * (cradle_balls - 1);
  const double top = bar_height(model);
  const Swing& swing = part_at(cradle.swings, time);
  for (const double x : {-bar_depth, bar_depth}) {
    add_rod(scene, {x, bar_left, top}, {x, bar_right, top}, 0.02);
  }
  for (std::size_t i = 0; i < cradle_balls; ++i) {
    const Vec3 pivot(0.0, first + 2.0 * cradle_radius * static_cast<double>(i), top);
    const double angle = swing.angle(i, time);
    const Vec3 place = pivot + cord * Vec3(0.0, std::sin(angle), -std::cos(angle));
    for (const double x : {-bar_depth, bar_depth}) {
      add_rod(scene, pivot + Vec3(x, 0.0, 0.0), place, 0.006);
    }
    const bool swings = std::abs(swing.speeds[i].y()) > 1e-9;
    add_ball(scene, place, cradle_radius,
             swings ? paint_of(colour_of(model)) : paint_of(palette::grey, 0.3F));
  }
}

/// Posts that hold all cradles' bars.
inline void add_stand(render::Scene& scene) {
  for (const double y : {bar_left, bar_right}) {
    for (const double x : {-bar_depth, bar_depth}) {
      add_rod(scene, {x, y, ground_height}, {x, y, bar_height(0)}, 0.02);
    }
  }
}

inline constexpr double table_width = 1.38;

inline double table_middle(std::size_t model) {
  return (table_width + 0.06) * (static_cast<double>(model) - 1.0);
}

/// A table that is tilted up to the eye, which sees it from above, with the axis of symmetry.
inline void add_table(render::Scene& scene, const Break& played, std::size_t model, double time) {
  const Vec3 out = towards_eye.normalized();
  const Vec3 up = out.cross(Vec3::UnitY());
  const Vec3 middle(0.0, table_middle(model), -0.24);
  Mat3 world_from_table;
  world_from_table << Vec3::UnitY(), up, out;
  constexpr double half_height = 1.2;
  scene.boxes.push_back({{middle - 0.03 * out, world_from_table},
                         {0.5 * table_width, half_height, 0.03},
                         paint_of(palette::grey, 0.75F)});
  const Vec3 foot = middle - 0.97 * half_height * up + 0.01 * out;
  const Vec3 head = middle + 0.97 * half_height * up + 0.01 * out;
  scene.trails.push_back({{foot, head, foot}, palette::grey, 1.5});

  const FreeFlight& flight = part_at(played.flights, time);
  for (std::size_t i = 0; i < flight.balls.size(); ++i) {
    const RigidBody& ball = flight.balls[i];
    const Vec3 on_table = ball.position + (time - flight.start) * ball.velocity;
    const Vec3 place = middle - 0.25 * up + world_from_table * on_table + rack_radius * out;
    add_ball(scene, place, rack_radius, paint_of(i == 0 ? palette::ink : colour_of(model)));
    if (ball.velocity.norm() < 0.02 * cue_speed) continue;
    const Vec3 tail = place + rack_radius * out;
    scene.arrows.push_back(
        {tail, tail + 0.6 * (world_from_table * ball.velocity), palette::ink, 0.022});
  }
}

/// A colour of the pile and the load up to which it stands, in weights of a ball.
struct LoadColour {
  double most;
  render::Colour colour;
  const char* words;
};
inline const std::array<LoadColour, 4> load_colours{{{0.0, palette::grey, "flies"},
                                                     {8.0, palette::sky, "up to 8"},
                                                     {25.0, palette::orange, "up to 25"},
                                                     {HUGE_VAL, palette::vermilion, "more"}}};

inline render::Paint paint_of(const PiledBall& ball) {
  std::size_t i = 0;
  while (i + 1 < load_colours.size() && ball.load > load_colours[i].most) ++i;
  return paint_of(load_colours[i].colour);
}

/// What the colours say.
inline void add_key(render::Scene& scene) {
  Vec3 place(0.0, -2.05, 2.1);
  for (const LoadColour& load : load_colours) {
    add_ball(scene, place, pile_radius, paint_of(load.colour));
    scene.labels.push_back({place + Vec3(0.0, 0.1, -0.1), load.words, palette::ink, 20.0});
    place.z() -= 0.2;
  }
}

/// The cylinder is cut open in front, and the panes are not drawn.
inline void add_pile(render::Scene& scene, const Pile& pile, double time) {
  scene.cylinders.push_back(
      {{{-0.1, 0.0, 0.0}, render::z_along_x}, 1.0, 0.2, paint_of(palette::grey, 0.55F)});
  for (const double side : {-1.0, 1.0}) {
    constexpr double thickness = 0.04;
    const Vec3 place(0.0, side * (half_width + 0.5 * thickness), ground_height + 1.0);
    scene.boxes.push_back(
        {{place, Mat3::Identity()}, {0.1, 0.5 * thickness, 1.0}, paint_of(palette::grey, 0.5F)});
  }
  const auto step = static_cast<std::size_t>(std::lround(time * steps_a_second));
  for (const PiledBall& ball : pile.steps[std::min(step, pile.steps.size() - 1)]) {
    add_ball(scene, ball.position, pile_radius, paint_of(ball));
  }
  add_key(scene);
}

}  // namespace lab::multi_contact
