#include "common/obj_file.hpp"

#include <tiny_obj_loader.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace common {
namespace {

constexpr std::string_view blank = " \t\r";
constexpr std::size_t longest_shown = 40;

/// A word of a file in a message: short, and on one line whatever is in it.
std::string shown(std::string_view word) {
  std::string text(word.substr(0, longest_shown));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + text + "'";
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(blank);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(blank), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

bool is_finite_number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

/// One to three whole numbers with slashes between, the first there and none zero.
bool is_corner(std::string_view word) {
  for (int part = 0; part < 3; ++part) {
    const std::size_t slash = word.find('/');
    const std::string_view number = word.substr(0, slash);
    if (part == 0 || !number.empty()) {
      int index = 0;
      const auto [end, error] =
          std::from_chars(number.data(), number.data() + number.size(), index);
      if (error != std::errc() || end != number.data() + number.size() || index == 0) return false;
    }
    if (slash == std::string_view::npos) return true;
    word.remove_prefix(slash + 1);
  }
  return false;
}

/// What of a file is handed to the reader, which takes what it cannot read for zero.
class Lines {
 public:
  Lines(std::istream& stream, std::string name) : name_(std::move(name)) {
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      take(line, number);
      text_ += '\n';  // a line that is passed over still counts
    }
    if (stream.bad()) throw std::runtime_error(name_ + ": cannot be read");
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::size_t line_of_face(std::size_t face) const { return face_lines_[face]; }

 private:
  void take(const std::string& line, std::size_t number) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty() || (words[0] != "v" && words[0] != "f")) return;
    const auto fail = [&](const std::string& why) {
      throw std::runtime_error(name_ + ":" + std::to_string(number) + ": " + why);
    };
    const bool is_face = words[0] == "f";
    if (is_face && words.size() != 4) {
      fail("want a triangle, got a face of " + std::to_string(words.size() - 1) + " corners");
    }
    if (words.size() < 4) fail("want three coordinates, got " + std::to_string(words.size() - 1));
    for (std::size_t i = 1; i < 4; ++i) {
      if (is_face && !is_corner(words[i])) fail("this is no index: " + shown(words[i]));
      if (!is_face && !is_finite_number(words[i])) {
        fail("this is no finite number: " + shown(words[i]));
      }
    }
    if (is_face) face_lines_.push_back(number);
    for (std::size_t i = 0; i < 4; ++i) (text_ += words[i]) += ' ';
  }

  std::string name_;
  std::string text_;
  std::vector<std::size_t> face_lines_;
};

/// Of several lines the first, without what ends it.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

TriangleMesh read_obj(std::istream& stream, const std::string& name) {
  const Lines lines(stream, name);
  std::istringstream text(lines.text());
  tinyobj::attrib_t read;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&read, &shapes, &materials, &warning, &error, &text, nullptr, false)) {
    throw std::runtime_error(name + ": " + first_line(error));
  }
  TriangleMesh mesh;
  for (std::size_t i = 0; i + 2 < read.vertices.size(); i += 3) {
    mesh.vertices.emplace_back(read.vertices[i], read.vertices[i + 1], read.vertices[i + 2]);
  }
  for (const tinyobj::shape_t& shape : shapes) {
    const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        const int index = corners[i + k].vertex_index;
        if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size()) {
          throw std::runtime_error(
              name + ":" + std::to_string(lines.line_of_face(mesh.triangles.size())) + ": vertex " +
              std::to_string(index + 1LL) + " of " + std::to_string(mesh.vertices.size()));
        }
        triangle[k] = static_cast<std::uint32_t>(index);
      }
      mesh.triangles.push_back(triangle);
    }
  }
  if (mesh.triangles.empty()) throw std::runtime_error(name + ": it has no triangle");
  return mesh;
}

TriangleMesh read_obj(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  return read_obj(file, path);
}

}  // namespace common
