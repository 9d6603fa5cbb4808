#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/draw/camera.hpp"
#include "render/scene.hpp"

namespace render {

/// A motion that is shown as numbered frames and as a film strip.
struct Film {
  std::string title;                ///< of the strip, as in "Tennis-racket tumble"
  std::string subtitle;             ///< one sentence: what to see
  std::string parameters;           ///< foot of the strip, left
  std::string measured;             ///< foot of the strip, right: errors that the scene measured
  double duration = 1.0;            ///< [s]
  std::vector<double> strip_times;  ///< one tile each [s]
  Bounds bounds;                    ///< what every frame must show
  Vec3 towards_eye = Vec3(1.0, -2.0, 0.9);     ///< direction from the scene to the camera
  std::function<Scene(double time)> scene_at;  ///< empty if all of it is missing
  std::vector<std::string> missing;            ///< steps left out because they are not written yet
};

/// Runs the body of every scene program: it reads the arguments, draws frames and strip, and
/// returns the exit code. Any error becomes one line on stderr and a non-zero code. The output
/// folder appears whole or not at all.
///
///   --out DIR        where frame_0000.png …, strip.png and film.json go (required)
///   --size WxH       of a frame, 16x16 to 8192x8192; default 1280x720
///   --fps F          frames a second, in (0, 240]; default 25
///   --from S --to S  the part of the motion, within [0, duration]
///   --quality Q      draft, film or report; default film (the strip is always report)
///   --white          pure white page, for print
int film_main(int argc, char** argv, const std::function<Film()>& make_film);

}  // namespace render
