#include "wend/io/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <system_error>
#include <utility>

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPiece = std::size_t{1} << 20;

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

/// A regular file that is not too large, opened, and its size.
struct OpenFile {
  std::ifstream stream;
  std::size_t size;
};

Expected<OpenFile, IoError> open_file(const fs::path& file, std::size_t largest) {
  const auto size = checked_size(file, largest);
  if (!size) return io_failure(file.string(), 0, size.error());
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::error_code error(errno, std::generic_category());
    return io_failure(file.string(), 0, "cannot be opened: " + error.message());
  }
  return OpenFile{std::move(stream), static_cast<std::size_t>(*size)};
}

}  // namespace

Expected<std::string, IoError> read_file(const fs::path& file, std::size_t largest) {
  auto open = open_file(file, largest);
  if (!open) return Unexpected<IoError>(open.error());
  std::string bytes(open->size, '\0');
  open->stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (open->stream.bad()) return io_failure(file.string(), 0, "cannot be read");
  bytes.resize(static_cast<std::size_t>(open->stream.gcount()));
  return bytes;
}

Expected<FilePieces, IoError> FilePieces::open(const fs::path& file, std::size_t largest) {
  auto open = open_file(file, largest);
  if (!open) return Unexpected<IoError>(open.error());
  return FilePieces(std::move(open->stream), open->size);
}

FilePieces::FilePieces(std::ifstream stream, std::size_t size)
    : stream_(std::move(stream)), size_(size), piece_(std::min(size, kPiece), '\0') {}

std::string_view FilePieces::next() {
  stream_.read(piece_.data(), static_cast<std::streamsize>(piece_.size()));
  return std::string_view(piece_).substr(0, static_cast<std::size_t>(stream_.gcount()));
}

}  // namespace wend
