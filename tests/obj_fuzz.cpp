// Reads mutated OBJ files: each gives a sound mesh or one line that names it, and never a crash.
// usage: obj_fuzz COUNT
#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>

#include "common/course/run_main.hpp"
#include "common/geometry/obj_file.hpp"

namespace {

const std::vector<std::string> seeds{
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1/1/1 2//4 -1\n",
    "# a mesh\no part\nv -1.5e-3 2 +4\nv 1 0 0 1\nv 0 1 0\nvn 0 0 1\nvt 0 1\ng a b\nusemtl red\n"
    "s off\nf -3 -2 -1\r\nl 1 2\np 1\n",
    "mtllib none.mtl\nv 1 2 3\nv 4 5 6\nv 7 8 9\nf 1/2 2/2 3/2\nv 1e300 1 1\nf 4 1 2\n"};

const std::vector<std::string> words{
    "nan",        "inf",         "-",         "0",           "-0",        "99999999999999999999",
    "2147483647", "-2147483648", "1e999",     "1e-999",      "f",         "v",
    "\n",         "\r",          "\\\n",      "/",           "//",        "///",
    "\t",         "#",           "f 1 2 3\n", "f 1 2 3 4\n", "v 1 2\n",   "vn ",
    "vp ",        "vw 1 ",       "t ",        "mtllib x\n",  "usemtl \n", "l 1\n",
    "."};

class Mutator {
 public:
  std::string next() {
    std::string text = seeds[below(seeds.size())];
    for (std::size_t edits = 1 + below(6); edits > 0; --edits) edit(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  void edit(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t kind = below(6);
    if (kind == 0) text.insert(at, 1, static_cast<char>(below(256)));
    if (kind == 1) text.erase(at, 1 + below(5));
    if (kind == 2 && at < text.size()) text[at] = static_cast<char>(below(256));
    if (kind == 3) text.insert(at, words[below(words.size())]);
    if (kind == 4) text.insert(at, text.substr(below(text.size() + 1), below(30)));
    if (kind == 5 && at < text.size()) text[at] = "0123456789-+./e \nvf"[below(19)];
  }

  std::mt19937_64 engine_{1};
};

void expect(bool holds, const std::string& what, const std::string& text) {
  if (!holds) throw std::runtime_error(what + ", of the file\n" + text);
}

/// Whether it gave a mesh.
bool try_one(const std::string& text) {
  std::istringstream stream(text);
  try {
    const common::TriangleMesh mesh = common::read_obj(stream, "fuzz.obj");
    common::require_sound(mesh);
    return true;
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    expect(message.starts_with("fuzz.obj:"), "the message does not name the file: " + message,
           text);
    expect(message.find('\n') == std::string::npos, "more than one line: " + message, text);
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  return common::run_main([&] {
    const long count = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000;
    Mutator mutator;
    long meshes = 0;
    for (long i = 0; i < count; ++i) meshes += try_one(mutator.next()) ? 1 : 0;
    std::cout << count << " files: " << meshes << " meshes, " << count - meshes << " refused\n";
    expect(count < 100 || (meshes > 0 && meshes < count), "all files are alike", "");
  });
}
