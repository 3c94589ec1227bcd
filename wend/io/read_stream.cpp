#include "wend/io/read_stream.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStreamPiece = std::size_t{64} << 10;

/// An open file that is closed again, unless it is standard input.
class Descriptor {
 public:
  explicit Descriptor(const fs::path& file)
      : number_(is_standard_input(file) ? STDIN_FILENO : open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  }
  ~Descriptor() {
    if (number_ > STDIN_FILENO) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
};

std::string message_of(int error) {
  return std::error_code(error, std::generic_category()).message();
}

}  // namespace

bool is_standard_input(const fs::path& file) { return file == "-" || file == "/dev/stdin"; }

bool is_stream(const fs::path& file) {
  if (is_standard_input(file)) return true;
  const std::string name = file.string();
  if (name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/")) return true;
  std::error_code error;
  return fs::is_fifo(fs::status(file, error));
}

std::string stream_name(const fs::path& file) {
  return is_standard_input(file) ? "standard input" : file.string();
}

Expected<std::string, IoError> read_stream(const fs::path& file, std::size_t largest) {
  const auto failure = [&file](std::string what) {
    return io_failure(stream_name(file), 0, std::move(what));
  };
  const Descriptor descriptor(file);
  if (descriptor.number() < 0) return failure("cannot be opened: " + message_of(errno));
  std::string bytes;
  std::size_t size = 0;
  for (;;) {
    if (bytes.size() - size < kStreamPiece) bytes.resize(std::max(2 * bytes.size(), kStreamPiece));
    const ssize_t got = read(descriptor.number(), bytes.data() + size, kStreamPiece);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure("cannot be read: " + message_of(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > largest) {
      return failure(fmt::format("too many bytes, at most {} are read", largest));
    }
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace wend
