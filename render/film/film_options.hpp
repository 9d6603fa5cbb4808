#pragma once

#include <filesystem>
#include <string>

#include "render/draw/renderer.hpp"
#include "render/film/film.hpp"

namespace render {

/// The arguments of a scene program.
struct FilmOptions {
  std::filesystem::path folder;
  PictureOptions picture;
  double frames_per_second = 25.0;
  double from = 0.0;      ///< [s]
  double to = -1.0;       ///< [s]; negative: the film's end
  bool is_sized = false;  ///< a size is given: the strip's tiles have its shape, too
};

/// Reads the arguments that film_main describes. Throws std::invalid_argument with one line that
/// names what is wrong.
FilmOptions film_options(int argc, const char* const* argv);

}  // namespace render
