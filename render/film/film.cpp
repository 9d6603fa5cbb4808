#include "render/film/film.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <future>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "common/course/run_main.hpp"
#include "render/draw/renderer.hpp"
#include "render/draw/scene_check.hpp"
#include "render/draw/view.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/progress.hpp"
#include "render/files/staged_folder.hpp"
#include "render/film/film_facts.hpp"
#include "render/film/film_options.hpp"
#include "render/film/film_strip.hpp"

namespace render {
namespace {

void require(bool is_right, const std::string& message) {
  if (!is_right) throw std::invalid_argument(message);
}

// As in frame_0012.png.
std::string frame_file(int frame) {
  std::ostringstream name;
  name << "frame_" << std::setw(4) << std::setfill('0') << frame << ".png";
  return name.str();
}

bool is_film_file(const std::string& name) {
  if (name == "strip.png" || name == "film.json") return true;
  int frame = 0;
  return std::sscanf(name.c_str(), "frame_%d.png", &frame) == 1 && name == frame_file(frame);
}

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

// Sets the end of the part to be shown, and checks the film against it.
void fit_to_film(FilmOptions& options, const Film& film) {
  require(std::isfinite(film.duration) && film.duration > 0.0,
          "the film's duration is not positive and finite");
  require(static_cast<bool>(film.scene_at),
          film.missing.empty()
              ? "the film has no scenes"
              : "nothing to draw, because not written yet: " + listed(film.missing));
  if (options.to < 0.0) options.to = film.duration;
  std::ostringstream end;
  end << film.duration << " s";
  require(options.to <= film.duration, "--to is after the film's end at " + end.str());
  require(options.from <= options.to,
          "--from is after " + (options.to < film.duration ? std::string("--to")
                                                           : "the film's end at " + end.str()));
}

int frames_of(const FilmOptions& options) {
  constexpr double rounding = 1e-9;  // of a time that should hit the last frame
  const double frames =
      std::floor((options.to - options.from) * options.frames_per_second + rounding) + 1.0;
  constexpr double most = 100000.0;
  require(frames <= most, "more than 100000 frames: give a smaller --fps or a shorter time");
  return static_cast<int>(frames);
}

std::string time_stamp(double time) {
  std::ostringstream out;
  out << "t = " << std::fixed << std::setprecision(2) << time << " s";
  return out.str();
}

void draw_frames(Renderer& renderer, const Film& film, const FilmOptions& options,
                 const StagedFolder& folder, int frames) {
  const double aspect = static_cast<double>(options.picture.width) / options.picture.height;
  const Camera camera = camera_framing(film.bounds, film.towards_eye, aspect);
  Progress progress("frame", frames);
  std::map<std::string, double> broken;  // what is left out, and since when
  std::future<void> written;  // a frame is packed and written while the next one is drawn
  for (int frame = 0; frame < frames; ++frame) {
    const double time = std::min(options.to, options.from + frame / options.frames_per_second);
    Scene scene = film.scene_at(time);
    for (const std::string& complaint : leave_out_broken(scene))
      broken.try_emplace(complaint, time);
    Image image = renderer.picture(scene, camera, options.picture);
    if (written.valid()) written.get();
    written = std::async(std::launch::async,
                         [image = std::move(image), file = folder.file(frame_file(frame))] {
                           write_png(image, file);
                         });
    progress.show(frame + 1);
  }
  written.get();
  for (const auto& [complaint, time] : broken) {
    std::cerr << "left out from " << time_stamp(time) << ": " << complaint
              << "; ./tumble test shows which step is wrong\n";
  }
}

// Width over height of what the bounds cover as the camera sees them, within what suits a tile.
double tile_aspect(const Film& film) {
  const CameraAxes axes = camera_axes(film.towards_eye);
  const Vec3 extent = film.bounds.high - film.bounds.low;
  const double width = axes.right.cwiseAbs().dot(extent);
  const double height = axes.up.cwiseAbs().dot(extent);
  return std::clamp(width / std::max(height, 1e-9 * width), 0.75, 1.9);
}

// The film's own times where all of it is shown; else as many, evenly over the part that is.
std::vector<double> strip_times(const Film& film, const FilmOptions& options) {
  if (film.strip_times.empty()) return {options.from};
  if (options.from <= 0.0 && options.to >= film.duration) return film.strip_times;
  std::vector<double> times{options.from};
  const double length = options.to - options.from;
  const std::size_t gaps = length > 0.0 ? film.strip_times.size() - 1 : 0;
  for (std::size_t i = 1; i <= gaps; ++i) {
    times.push_back(options.from + length * static_cast<double>(i) / static_cast<double>(gaps));
  }
  return times;
}

void draw_strip(Renderer& renderer, const Film& film, const FilmOptions& options,
                const StagedFolder& folder) {
  const std::vector<double> times = strip_times(film, options);
  PictureOptions picture;
  picture.quality = Quality::report;
  picture.white = options.picture.white;
  picture.height = 330;
  const double aspect = options.is_sized
                            ? static_cast<double>(options.picture.width) / options.picture.height
                            : tile_aspect(film);
  picture.width = static_cast<int>(std::lround(picture.height * aspect));
  const Camera camera = camera_framing(film.bounds, film.towards_eye, aspect);
  std::vector<StripTile> tiles;
  for (const double time : times) {
    require(std::isfinite(time), "a time of the strip is not finite");
    Scene scene = film.scene_at(time);
    leave_out_broken(scene);
    tiles.push_back({renderer.picture(scene, camera, picture), time_stamp(time)});
  }
  constexpr int widest = 1760;
  const int columns = strip_columns(static_cast<int>(tiles.size()), picture.width, widest);
  const std::string left_out =
      film.missing.empty() ? "" : " (left out: " + listed(film.missing) + ")";
  const StripText text{film.title, film.subtitle + left_out, film.parameters, film.measured};
  write_png(film_strip(tiles, text, columns), folder.file("strip.png"));
}

void make(FilmOptions options, const std::function<Film()>& make_film) {
  const Film film = make_film();
  fit_to_film(options, film);
  if (!film.missing.empty()) {
    std::cerr << "left out, because not written yet or broken: " << listed(film.missing) << '\n';
  }
  const int frames = frames_of(options);
  StagedFolder folder(options.folder, is_film_file);
  Renderer renderer;
  draw_frames(renderer, film, options, folder, frames);
  draw_strip(renderer, film, options, folder);
  write_file_atomically(folder.file("film.json"), film_facts(film, options, frames));
  folder.publish();
  std::cerr << "wrote " << frames << " frames and a strip to " << folder.target().string() << '\n';
}

}  // namespace

int film_main(int argc, char** argv, const std::function<Film()>& make_film) {
  return common::run_main([&] { make(film_options(argc, argv), make_film); });
}

}  // namespace render
