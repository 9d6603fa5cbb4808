#include "render/film_folder.hpp"

#include <unistd.h>

#include <stdexcept>
#include <system_error>

namespace render {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& reason) {
  throw std::runtime_error("cannot write " + folder.string() + ": " + reason);
}

bool is_film_file(const std::string& name) {
  if (name == strip_file || name == facts_file) return true;
  const std::string start = "frame_";
  const std::string end = ".png";
  if (name.size() <= start.size() + end.size()) return false;
  const std::string digits = name.substr(start.size(), name.size() - start.size() - end.size());
  return name.compare(0, start.size(), start) == 0 &&
         name.compare(name.size() - end.size(), end.size(), end) == 0 &&
         digits.find_first_not_of("0123456789") == std::string::npos;
}

void require_film(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) fail(folder, "it is a file");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || !is_film_file(name)) {
      fail(folder, "it holds " + name + ", which is no part of a film");
    }
  }
}

// The folder itself where the path is a link to it or ends with a slash.
fs::path resolved(const fs::path& folder) {
  fs::path path = fs::weakly_canonical(fs::absolute(folder));
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

FilmFolder::FilmFolder(const fs::path& target) : target_(resolved(target)), part_(target_) {
  part_ += ".part" + std::to_string(getpid());
  require_film(target_);
  std::error_code error;
  fs::create_directories(part_, error);
  if (error) fail(target_, error.message());
}

FilmFolder::~FilmFolder() {
  std::error_code ignored;
  fs::remove_all(part_, ignored);
}

void FilmFolder::put_in_place() {
  fs::path old = target_;
  old += ".old" + std::to_string(getpid());
  std::error_code error;
  const bool is_there = fs::exists(target_);
  if (is_there) {
    require_film(target_);
    fs::rename(target_, old, error);
    if (error) fail(target_, error.message());
  }
  fs::rename(part_, target_, error);
  if (error) {
    std::error_code ignored;
    if (is_there) fs::rename(old, target_, ignored);
    fail(target_, error.message());
  }
  fs::remove_all(old, error);
}

std::string frame_file(int frame) {
  const std::string digits = std::to_string(frame);
  const std::string zeros(digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return "frame_" + zeros + digits + ".png";
}

}  // namespace render
