#include "wend/io/write_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

/// What went wrong, empty if nothing did.
std::string write_bytes(const fs::path& file, std::string_view bytes) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (stream) return {};
  const std::error_code error(errno, std::generic_category());
  return "cannot be written: " + error.message();
}

/// The file itself, at the end of symbolic links.
fs::path target_of(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(file, error))) return file;
  const fs::path target = fs::canonical(file, error);
  return error ? file : target;
}

}  // namespace

Expected<void, IoError> write_file(const fs::path& file, std::string_view bytes) {
  const fs::path target = target_of(file);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    const std::string wrong = write_bytes(target, bytes);
    if (!wrong.empty()) return io_failure(file.string(), 0, wrong);
    return {};
  }
  const fs::path temporary = fmt::format("{}.{}.part", target.string(), getpid());
  std::string wrong = write_bytes(temporary, bytes);
  if (wrong.empty()) {
    error.clear();
    fs::rename(temporary, target, error);
    if (!error) return {};
    wrong = "cannot be written: " + error.message();
  }
  fs::remove(temporary, error);
  return io_failure(file.string(), 0, wrong);
}

}  // namespace wend
