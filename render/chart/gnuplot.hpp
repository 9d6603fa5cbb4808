#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace render {

/// Runs gnuplot on a script of `folder`, and writes its messages to the file `log` there. Returns
/// its exit code, or nothing if it is not installed.
std::optional<int> run_gnuplot(const std::string& script, const std::string& log,
                               const std::filesystem::path& folder);

}  // namespace render
