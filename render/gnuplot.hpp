#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace render {

/// Runs gnuplot on a script of `folder`; what it says goes into the file `log` there. Nothing where
/// it is not installed, else its exit code.
std::optional<int> run_gnuplot(const std::string& script, const std::string& log,
                               const std::filesystem::path& folder);

}  // namespace render
