#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/course/if_written.hpp"
#include "falling_sheet.hpp"

/// The motions of the scene, and what the student's functions find in them.
namespace lab::discrete_particle_cylinder {

inline constexpr double duration = 3.2;
inline constexpr double frame_time = 0.02;
inline constexpr int frames = 160;
inline constexpr Cylinder cylinder{0.35};

inline constexpr int rows = 9;
inline constexpr int columns = 4;
inline constexpr double spacing = 0.3;

/// The state of a sheet at a moment.
struct Moment {
  Sheet sheet;
  std::vector<std::size_t> sunk;  ///< edges that reach into the cylinder
};

/// A sheet through the whole film.
struct Fall {
  const char* name;
  double x;
  std::vector<Moment> moments;
};

inline std::vector<std::size_t> sunk_edges(const Sheet& sheet, std::vector<std::string>& missing) {
  const auto edges = [&] { return sheet_contacts(sheet, cylinder).edges; };
  return common::if_written(missing, edges).value_or(std::vector<std::size_t>());
}

inline std::optional<Fall> fallen(Fall fall, const PushOut& push_out,
                                  std::vector<std::string>& missing) {
  constexpr int steps_a_frame = 5;
  return common::if_written(missing, [&] {
    FallingSheet falling(rows, columns, spacing, {fall.x, 0.0, 0.65}, 0.12);
    for (int frame = 0; frame <= frames; ++frame) {
      fall.moments.push_back({falling.sheet, sunk_edges(falling.sheet, missing)});
      for (int i = 0; i < steps_a_frame; ++i) {
        falling.step(frame_time / steps_a_frame, cylinder, push_out);
      }
    }
    return fall;
  });
}

/// A particle that is shot across the cylinder, and the sample that finds it.
struct Shot {
  double launch;  ///< [s]
  StraightPath path;
  std::optional<ParticleContact> contact;
};

inline constexpr int shot_count = 3;
inline constexpr int samples = 3;
inline constexpr double flight = 0.9;  // [s]
inline constexpr double shot_radius = 0.07;
inline constexpr double reach = cylinder.radius + shot_radius;
inline constexpr double height = 0.8 * reach;  // above the axis: the chord is then 1.2 reach
inline constexpr double chord = 1.2 * reach;
inline constexpr double sample_distance = 1.5 * chord;

/// Returns lanes side by side. Their starts are spread evenly over the distance of two samples.
inline std::optional<std::vector<Shot>> shots(std::vector<std::string>& missing) {
  return common::if_written(missing, [&] {
    std::vector<Shot> all;
    for (int i = 0; i < shot_count; ++i) {
      const double phase = (i + 0.5) / shot_count;
      const StraightPath path{{0.75 + 0.3 * i, -1.3 + phase * sample_distance, height},
                              {0.0, samples * sample_distance / flight, 0.0},
                              flight};
      all.push_back(
          {0.1 + 0.8 * i, path, first_sampled_contact(path, samples, shot_radius, cylinder)});
    }
    return all;
  });
}

}  // namespace lab::discrete_particle_cylinder
