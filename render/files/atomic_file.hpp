#pragma once

#include <filesystem>
#include <string_view>

namespace render {

/// Writes a file whole or not at all: under a temporary name in the same folder, which it renames.
/// Throws std::runtime_error "cannot write PATH: reason" and leaves nothing behind.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace render
