#include "wend/io/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

std::string cannot_be_written(int error) {
  return "cannot be written: " + std::error_code(error, std::generic_category()).message();
}

/// What went wrong, empty if nothing did.
std::string write_bytes(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot_be_written(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

std::string write_bytes(const fs::path& file, std::string_view bytes) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) return cannot_be_written(errno);
  std::string wrong = write_bytes(descriptor, bytes);
  if (::close(descriptor) != 0 && wrong.empty()) wrong = cannot_be_written(errno);
  return wrong;
}

/// Writes a file that gets its name only when it is whole, so that nothing is left of it where the
/// program is ended before. False where the file system has no files without a name.
bool write_unnamed(const fs::path& file, std::string_view bytes, std::string& wrong) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) return false;
  wrong = write_bytes(descriptor, bytes);
  const std::string unnamed = fmt::format("/proc/self/fd/{}", descriptor);
  const bool named = !wrong.empty() || ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, file.c_str(),
                                                AT_SYMLINK_FOLLOW) == 0;
  ::close(descriptor);
  return named;
}

/// The same, or, where there is no such file, one that is removed where writing it fails.
std::string write_temporary(const fs::path& file, std::string_view bytes) {
  std::string wrong;
  if (write_unnamed(file, bytes, wrong)) return wrong;
  return write_bytes(file, bytes);
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
  std::string wrong = write_temporary(temporary, bytes);
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
