#pragma once

#include <filesystem>

namespace render {

/// An output folder that appears whole or not at all: files are written into a hidden sibling,
/// which takes the place of what stood there before when all of them are done.
class StagedFolder {
 public:
  /// Throws std::runtime_error "cannot write PATH: reason" where the sibling cannot be made.
  explicit StagedFolder(std::filesystem::path target);
  /// Removes what was not published.
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// Where to write.
  const std::filesystem::path& path() const { return staged_; }
  /// Replaces the target. Throws std::runtime_error "cannot write PATH: reason".
  void publish();

 private:
  std::filesystem::path target_;
  std::filesystem::path staged_;
};

}  // namespace render
