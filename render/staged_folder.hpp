#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace render {

/// An output folder that appears whole or not at all: files are written into a sibling, which takes
/// the place of what stood there before when all of them are done.
class StagedFolder {
 public:
  /// is_own  which file names belong to such a folder
  /// Throws std::runtime_error "cannot write PATH: reason" where the sibling cannot be made, and
  /// where `target` holds anything but own files: they would be lost.
  StagedFolder(const std::filesystem::path& target,
               std::function<bool(const std::string& name)> is_own);
  /// Removes what was not published.
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Where a file goes until publish().
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return staged_ / name; }
  [[nodiscard]] const std::filesystem::path& target() const { return target_; }
  [[nodiscard]] const std::filesystem::path& staged() const { return staged_; }

  /// Replaces the target. Throws std::runtime_error "cannot write PATH: reason".
  void publish();

 private:
  void require_own_files() const;

  std::filesystem::path target_;
  std::filesystem::path staged_;
  std::function<bool(const std::string&)> is_own_;
};

}  // namespace render
