#include "wend/io/read_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

/// The size of a regular file that is not too large, else why it is not read.
Expected<std::uintmax_t, std::string> checked_size(const fs::path& file, std::size_t largest) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) return Unexpected<std::string>("cannot be opened: " + error.message());
  if (!fs::is_regular_file(status)) return Unexpected<std::string>("not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return Unexpected<std::string>("cannot be opened: " + error.message());
  if (size > largest) {
    return Unexpected<std::string>(
        fmt::format("{} bytes are too many, at most {} are read", size, largest));
  }
  return size;
}

}  // namespace

Expected<std::string, IoError> read_file(const fs::path& file, std::size_t largest) {
  const auto size = checked_size(file, largest);
  if (!size) return io_failure(file.string(), 0, size.error());
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::error_code error(errno, std::generic_category());
    return io_failure(file.string(), 0, "cannot be opened: " + error.message());
  }
  std::string bytes(*size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (stream.bad()) return io_failure(file.string(), 0, "cannot be read");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

}  // namespace wend
