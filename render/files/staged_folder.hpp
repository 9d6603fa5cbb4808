#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace render {

/// An output folder that appears whole or not at all. Files are written into a sibling folder. When
/// all of them are done, the sibling takes the place of the old folder.
class StagedFolder {
 public:
  /// is_own  tells which file names belong to such a folder
  /// Throws std::runtime_error "cannot write PATH: reason" if the sibling cannot be made, or if
  /// `target` contains other files than own ones, because they would be lost.
  StagedFolder(const std::filesystem::path& target,
               std::function<bool(const std::string& name)> is_own);
  /// Removes everything that was not published.
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Returns the place of a file until publish().
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
