#include "render/files/staged_folder.hpp"

#include <unistd.h>

#include <stdexcept>
#include <system_error>
#include <utility>

namespace render {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& folder, const std::string& reason) {
  throw std::runtime_error("cannot write " + folder.string() + ": " + reason);
}

/// The folder itself where the path is a link to it or ends with a slash.
fs::path resolved(const fs::path& folder) {
  const fs::path path = fs::weakly_canonical(fs::absolute(folder));
  return path.has_filename() ? path : path.parent_path();
}

fs::path sibling(fs::path path, const std::string& purpose) {
  path += "." + purpose + std::to_string(getpid());
  return path;
}

}  // namespace

StagedFolder::StagedFolder(const fs::path& target, std::function<bool(const std::string&)> is_own)
    : target_(resolved(target)), staged_(sibling(target_, "part")), is_own_(std::move(is_own)) {
  require_own_files();
  std::error_code error;
  fs::create_directories(staged_, error);
  if (error) fail(target_, error.message());
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staged_, ignored);
}

void StagedFolder::require_own_files() const {
  std::error_code error;
  if (!fs::exists(target_, error)) return;
  if (!fs::is_directory(target_)) fail(target_, "it is a file");
  for (const fs::directory_entry& entry : fs::directory_iterator(target_)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || !is_own_(name)) {
      fail(target_, "it contains " + name + ", which would be lost; choose another folder");
    }
  }
}

void StagedFolder::publish() {
  require_own_files();
  const fs::path old = sibling(target_, "old");
  std::error_code error;
  const bool is_there = fs::exists(target_);
  if (is_there) fs::rename(target_, old, error);
  if (!error) fs::rename(staged_, target_, error);
  if (error) {
    std::error_code ignored;
    if (is_there) fs::rename(old, target_, ignored);
    fail(target_, error.message());
  }
  fs::remove_all(old, error);
}

}  // namespace render
