#include "render/files/atomic_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

namespace render {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::error_code& reason) {
  throw std::runtime_error("cannot write " + path.string() + ": " + reason.message());
}

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return last_error();
  std::error_code error;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) error = last_error();
  // A full disk may show only here, when the last buffer goes out.
  if (std::fclose(file) != 0 && !error) error = last_error();
  return error;
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path part = path;
  part += ".part" + std::to_string(getpid());
  std::error_code error = write_bytes(part, bytes);
  if (!error) std::filesystem::rename(part, path, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  fail(path, error);
}

}  // namespace render
