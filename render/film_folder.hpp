#pragma once

#include <filesystem>
#include <string>

namespace render {

/// A folder that appears whole or not at all: filled under a temporary name beside its own, then
/// put in the place of an earlier one.
class FilmFolder {
 public:
  /// Throws std::runtime_error where `target` cannot be made, or holds anything but a film: its
  /// files would be lost.
  explicit FilmFolder(const std::filesystem::path& target);
  /// Removes what was not put in place.
  ~FilmFolder();
  FilmFolder(const FilmFolder&) = delete;
  FilmFolder& operator=(const FilmFolder&) = delete;

  /// Where a file goes until put_in_place().
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return part_ / name; }
  [[nodiscard]] const std::filesystem::path& target() const { return target_; }

  /// Throws std::runtime_error that names the folder.
  void put_in_place();

 private:
  std::filesystem::path target_;
  std::filesystem::path part_;
};

/// Names of a film's files.
inline constexpr const char* strip_file = "strip.png";
inline constexpr const char* facts_file = "film.json";
std::string frame_file(int frame);  ///< as in frame_0012.png

}  // namespace render
