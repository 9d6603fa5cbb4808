#include "common/geometry/obj_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/geometry/polygon.hpp"

namespace common {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
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
  line = line.substr(0, line.find('#'));
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

/// All of the word as a number; false where it is none, or is beyond the type's range.
template <typename Number>
bool reads(std::string_view word, Number& number) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && stop == end;
}

/// The nearest double, which is 0 for what is too small for any other.
bool reads_coordinate(std::string_view word, double& number) {
  if (reads(word, number)) return std::isfinite(number);
  const std::string text(word);
  char* stop = nullptr;
  number = std::strtod(text.c_str(), &stop);
  const bool is_decimal = text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  return is_decimal && stop == text.c_str() + text.size() && !text.empty() &&
         std::abs(number) < 1.0;
}

/// Reads a file line by line; faces are made in the end, when all vertices are known.
class Reader {
 public:
  explicit Reader(std::string name) : name_(std::move(name)) {}

  TriangleMesh read(std::istream& stream) {
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      number_ = number;
      if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
      for (std::string more; goes_on(line) && std::getline(stream, more); ++number) line += more;
      take(words_of(line));
    }
    if (stream.bad()) throw std::runtime_error(name_ + ": cannot be read");
    for (const Face& face : faces_) add(face);
    if (mesh_.triangles.empty()) throw std::runtime_error(name_ + ": it has no triangle");
    return std::move(mesh_);
  }

 private:
  struct Face {
    std::size_t line;
    std::vector<long long> corners;  ///< from 1
  };

  /// Cuts off the "\" by which a line goes on in the next.
  static bool goes_on(std::string& line) {
    const std::size_t last = line.find_last_not_of('\r');
    if (last == std::string::npos || line[last] != '\\') return false;
    line.erase(last);
    line += ' ';
    return true;
  }

  void take(const std::vector<std::string_view>& words) {
    if (words.empty()) return;
    if (words[0] == "v") take_vertex(words);
    if (words[0] == "f") take_face(words);
  }

  void take_vertex(const std::vector<std::string_view>& words) {
    if (words.size() < 4) {
      fail(number_, "expected three coordinates, got " + std::to_string(words.size() - 1));
    }
    Vec3 vertex = Vec3::Zero();
    for (std::size_t i = 1; i < words.size(); ++i) {
      double number = 0.0;
      if (!reads_coordinate(words[i], number)) {
        fail(number_, "this is not a finite number: " + shown(words[i]));
      }
      if (i < 4) vertex[static_cast<int>(i) - 1] = number;
    }
    mesh_.vertices.push_back(vertex);
  }

  void take_face(const std::vector<std::string_view>& words) {
    if (words.size() < 4) {
      fail(number_, "expected three corners or more, got " + std::to_string(words.size() - 1));
    }
    Face face{number_, {}};
    for (std::size_t i = 1; i < words.size(); ++i) face.corners.push_back(corner(words[i]));
    faces_.push_back(face);
  }

  /// The vertex of "v", "v/t", "v//n" or "v/t/n", where t and n may be left out.
  [[nodiscard]] long long corner(std::string_view word) const {
    long long vertex = 0;
    std::string_view rest = word;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = rest.find('/');
      const std::string_view text = rest.substr(0, slash);
      long long number = 0;
      const bool is_number = reads(text, number) && number != 0;
      if (!is_number && (part == 0 || !text.empty())) break;
      if (part == 0) vertex = number;
      if (slash == std::string_view::npos) return from_first(vertex);
      rest.remove_prefix(slash + 1);
    }
    fail(number_, "this is not an index: " + shown(word));
  }

  /// An index that counts back from the last vertex so far, −1, as one that counts from 1.
  [[nodiscard]] long long from_first(long long vertex) const {
    const auto count = static_cast<long long>(mesh_.vertices.size());
    if (vertex > 0) return vertex;
    if (vertex + count >= 0) return vertex + count + 1;
    fail(number_, "vertex " + std::to_string(vertex) + " of " + std::to_string(count));
  }

  void add(const Face& face) {
    std::vector<std::uint32_t> corners;
    for (const long long vertex : face.corners) {
      if (vertex > static_cast<long long>(mesh_.vertices.size())) {
        fail(face.line,
             "vertex " + std::to_string(vertex) + " of " + std::to_string(mesh_.vertices.size()));
      }
      corners.push_back(static_cast<std::uint32_t>(vertex - 1));
    }
    for (const auto& triangle : triangulated(mesh_.vertices, std::move(corners))) {
      mesh_.triangles.push_back(triangle);
    }
  }

  [[noreturn]] void fail(std::size_t line, const std::string& why) const {
    throw std::runtime_error(name_ + ":" + std::to_string(line) + ": " + why);
  }

  std::string name_;
  std::size_t number_ = 0;
  TriangleMesh mesh_;
  std::vector<Face> faces_;
};

}  // namespace

TriangleMesh read_obj(std::istream& stream, const std::string& name) {
  return Reader(name).read(stream);
}

TriangleMesh read_obj(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  return read_obj(file, path);
}

}  // namespace common
