#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "catch.hpp"
#include "common/course/not_implemented.hpp"
#include "render/film/film.hpp"
#include "render_picture.hpp"

namespace {

using tests::files_in;
using tests::ScratchFolder;

render::Film falling_box() {
  render::Film film;
  film.title = "Falling \"box\"";
  film.subtitle = "g pulls";
  film.duration = 1.0;
  film.strip_times = {0.0, 0.5};
  film.bounds = {{-1.0, -1.0, 0.0}, {1.0, 1.0, 2.0}};
  film.missing = {"2.1 drag"};
  film.scene_at = [](double time) {
    render::Scene scene;
    render::Box box;
    box.placement.position.z() = 1.5 - time;
    scene.boxes.push_back(box);
    return scene;
  };
  return film;
}

struct Outcome {
  int code;
  std::string said;
};

Outcome run(std::vector<std::string> arguments,
            const std::function<render::Film()>& make_film = falling_box) {
  arguments.insert(arguments.begin(), "scene");
  std::vector<char*> argv;
  argv.reserve(arguments.size());
  for (std::string& argument : arguments) argv.push_back(argument.data());
  std::ostringstream said;
  std::streambuf* const before = std::cerr.rdbuf(said.rdbuf());
  const int code = render::film_main(static_cast<int>(argv.size()), argv.data(), make_film);
  std::cerr.rdbuf(before);
  return {code, said.str()};
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

TEST_CASE("A film appears whole with its facts and no frame of a longer one", "[render_film]") {
  const ScratchFolder scratch;
  const std::filesystem::path out = scratch.path() / "deep" / "film";
  const std::vector<std::string> options{"--out", out.string(), "--size",    "64x36",
                                         "--fps", "10",         "--quality", "draft"};
  const Outcome whole = run(options);
  INFO(whole.said);
  REQUIRE(whole.code == 0);
  CHECK(files_in(out) == 11 + 2);
  CHECK(tests::read_png(out / "frame_0010.png").width == 64);
  CHECK(tests::read_png(out / "strip.png").width > 500);
  const std::string facts = text_of(out / "film.json");
  CHECK(facts.find("\"title\": \"Falling \\\"box\\\"\"") != std::string::npos);
  CHECK(facts.find("\"frames\": 11") != std::string::npos);
  CHECK(facts.find("\"missing\": [\"2.1 drag\"]") != std::string::npos);

  std::vector<std::string> shorter = options;
  shorter.insert(shorter.end(), {"--from", "0.2", "--to", "0.4", "--white"});
  CHECK(run(shorter).code == 0);
  CHECK(files_in(out) == 3 + 2);
  CHECK(files_in(out.parent_path()) == 1);
}

TEST_CASE("The strip shows the part and the shape that are asked for", "[render_film]") {
  const ScratchFolder scratch;
  const std::filesystem::path out = scratch.path() / "film";
  const auto strip_of = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"--out", out.string(), "--fps", "1", "--quality", "draft"});
    std::vector<double> times;
    const Outcome outcome = run(more, [&] {
      render::Film film = falling_box();
      film.scene_at = [&times, scene_at = film.scene_at](double time) {
        times.push_back(time);
        return scene_at(time);
      };
      return film;
    });
    INFO(outcome.said);
    REQUIRE(outcome.code == 0);
    return times;
  };
  using Times = std::vector<double>;
  CHECK(strip_of({"--size", "64x64"}) == Times{0.0, 1.0, 0.0, 0.5});  // frames, then the strip
  const int square = tests::read_png(out / "strip.png").width;
  CHECK(strip_of({"--size", "128x64"}) == Times{0.0, 1.0, 0.0, 0.5});
  CHECK(tests::read_png(out / "strip.png").width > square + 600);  // two tiles, each wider by 330
  CHECK(strip_of({"--from", "0.25"}) == Times{0.25, 0.25, 1.0});
  CHECK(strip_of({"--from", "0.25", "--to", "0.75"}) == Times{0.25, 0.25, 0.75});
  CHECK(strip_of({"--from", "0.5", "--to", "0.5"}) == Times{0.5, 0.5});
}

TEST_CASE("What an answer makes NaN is left out and told and the rest is drawn", "[render_film]") {
  const ScratchFolder scratch;
  const std::filesystem::path out = scratch.path() / "film";
  const Outcome outcome = run({"--out", out.string(), "--size", "64x36", "--fps", "10"}, [] {
    render::Film film = falling_box();
    film.scene_at = [scene_at = film.scene_at](double time) {
      render::Scene scene = scene_at(time);
      render::Box box = scene.boxes[0];
      if (time > 0.55) box.placement.world_from_body.setConstant(std::nan(""));
      scene.boxes.push_back(box);
      scene.boxes.push_back(scene.boxes[0]);
      return scene;
    };
    return film;
  });
  CHECK(outcome.code == 0);
  CHECK(outcome.said.find("left out from t = 0.60 s: box 1: orientation is not finite; ./tumble "
                          "test shows which step is wrong\n") != std::string::npos);
  CHECK(outcome.said.find("box 2") == std::string::npos);
  CHECK(files_in(out) == 11 + 2);
}

TEST_CASE("A start after the end of the film is told where that is", "[render_film]") {
  const Outcome outcome = run({"--out", "/nowhere/film", "--from", "99"});
  CHECK(outcome.code != 0);
  CHECK(outcome.said == "error: --from is after the film's end at 1 s\n");
}

TEST_CASE("A film that fails leaves the folder as it was", "[render_film]") {
  const ScratchFolder scratch;
  const std::filesystem::path out = scratch.path() / "film";
  const std::vector<std::string> options{"--out", out.string(), "--size", "32x18"};
  const auto breaks_midway = [] {
    render::Film film = falling_box();
    film.scene_at = [](double time) -> render::Scene {
      if (time > 0.5) throw common::NotImplemented("1.2 point_velocity");
      return {};
    };
    return film;
  };
  const Outcome outcome = run(options, breaks_midway);
  CHECK(outcome.code != 0);
  CHECK(outcome.said.find("error: 1.2 point_velocity is not written yet\n") != std::string::npos);
  CHECK(files_in(scratch.path()) == 0);
}

TEST_CASE("A folder that holds anything but a film is not replaced", "[render_film]") {
  const ScratchFolder scratch;
  const std::filesystem::path notes = scratch.path() / "notes.txt";
  std::ofstream(notes) << "mine";
  const Outcome outcome = run({"--out", scratch.path().string(), "--size", "32x18"});
  CHECK(outcome.code != 0);
  CHECK(outcome.said.find("notes.txt") != std::string::npos);
  CHECK(text_of(notes) == "mine");
  CHECK(files_in(scratch.path()) == 1);
}

TEST_CASE("A wrong argument is one line that names it", "[render_film]") {
  const ScratchFolder scratch;
  const std::string out = (scratch.path() / "film").string();
  const std::vector<std::string> wrong = GENERATE(
      std::vector<std::string>{"--size", "64"}, std::vector<std::string>{"--size", "15x64"},
      std::vector<std::string>{"--size", "64x8193"}, std::vector<std::string>{"--size", "64x36x2"},
      std::vector<std::string>{"--fps", "0"}, std::vector<std::string>{"--fps", "241"},
      std::vector<std::string>{"--fps", "nan"}, std::vector<std::string>{"--from", "-1"},
      std::vector<std::string>{"--from", "2"}, std::vector<std::string>{"--to", "1.5"},
      std::vector<std::string>{"--to", "1s"}, std::vector<std::string>{"--quality", "best"},
      std::vector<std::string>{"--colour", "red"}, std::vector<std::string>{"--out"});
  std::vector<std::string> options{"--out", out};
  options.insert(options.end(), wrong.begin(), wrong.end());
  const Outcome outcome = run(options);
  INFO(outcome.said);
  CHECK(outcome.code != 0);
  CHECK(outcome.said.find(wrong.front()) != std::string::npos);
  CHECK(outcome.said.find('\n') == outcome.said.size() - 1);
  CHECK(files_in(scratch.path()) == 0);
}

TEST_CASE("A film without an output folder is refused", "[render_film]") {
  const Outcome outcome = run({});
  CHECK(outcome.code != 0);
  CHECK(outcome.said == "error: --out DIR is required\n");
}
