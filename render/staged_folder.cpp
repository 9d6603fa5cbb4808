#include "render/staged_folder.hpp"

#include <unistd.h>

#include <stdexcept>
#include <string>
#include <system_error>

namespace render {
namespace fs = std::filesystem;
namespace {

/// The folder's own name, without a slash at its end, which has none.
fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

fs::path hidden_sibling(const fs::path& path, const char* purpose) {
  std::string name = ".";
  name += path.filename().string();
  name += purpose + std::to_string(getpid());
  return path.parent_path() / name;
}

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw std::runtime_error("cannot write " + path.string() + ": " + error.message());
}

}  // namespace

StagedFolder::StagedFolder(fs::path target)
    : target_(without_slash(fs::absolute(target).lexically_normal())),
      staged_(hidden_sibling(target_, ".new")) {
  std::error_code error;
  if (fs::exists(target_, error) && !fs::is_directory(target_, error)) {
    fail(target_, std::make_error_code(std::errc::not_a_directory));
  }
  fs::remove_all(staged_, error);
  fs::create_directories(staged_, error);
  if (error) fail(target_, error);
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staged_, ignored);
}

void StagedFolder::publish() {
  const fs::path old = hidden_sibling(target_, ".old");
  std::error_code error;
  fs::rename(target_, old, error);  // fails where there is none yet
  error.clear();
  fs::rename(staged_, target_, error);
  if (error) {
    std::error_code ignored;
    fs::rename(old, target_, ignored);
    fail(target_, error);
  }
  fs::remove_all(old, error);
}

}  // namespace render
