#include "wend/io/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFilePiece = std::size_t{64} << 10;  // stays in the cache
constexpr std::size_t kStreamPiece = std::size_t{64} << 10;

std::string message_of(int error) {
  return std::error_code(error, std::generic_category()).message();
}

/// An open file that is closed at the end, unless it is standard input.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ > STDIN_FILENO) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  /// Closes the file; false if that fails, for example because the last bytes cannot be written.
  bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

Unexpected<Error> failure_of(const fs::path& file, const std::string& what) {
  return file_failure(file.string(), 0, what);
}

std::string cannot_be_written(int error) { return "cannot be written: " + message_of(error); }

/// Writes the bytes and returns an error, empty on success.
std::string write_bytes(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return cannot_be_written(errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

/// For a device, a pipe or the like.
std::string write_bytes(const fs::path& file, std::string_view bytes) {
  Descriptor open_file(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!open_file.is_open()) return cannot_be_written(errno);
  std::string wrong = write_bytes(open_file.number(), bytes);
  if (!open_file.close() && wrong.empty()) wrong = cannot_be_written(errno);
  return wrong;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A name beside the target that nobody can guess: somebody else could put a link there.
Expected<fs::path, std::string> temporary_name(const fs::path& target) {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) {
    return Unexpected<std::string>(cannot_be_written(errno));
  }
  return fs::path(fmt::format("{}.{:016x}.part", target.string(), number));
}

/// Who may read the file that is replaced, and whose it is.
struct Access {
  std::optional<struct stat> replaced;

  /// As open() takes it, which subtracts the umask; a file that is replaced is never open to more than before.
  mode_t mode() const { return replaced ? replaced->st_mode & 0777U : 0666U; }

  /// Gives a new file the owner, if that is allowed, and the permissions of the replaced one.
  bool give_to(int descriptor) const {
    if (!replaced) return true;
    const bool owned = ::fchown(descriptor, replaced->st_uid, replaced->st_gid) == 0 ||
                       ::fchown(descriptor, static_cast<uid_t>(-1), replaced->st_gid) == 0;
    // Without its group, the permissions of the group would be for others.
    const mode_t allowed = owned ? 0777U : 0707U;
    return ::fchmod(descriptor, replaced->st_mode & allowed) == 0;
  }
};

Access access_of(const fs::path& target) {
  struct stat status{};
  return {::stat(target.c_str(), &status) == 0 ? std::optional(status) : std::nullopt};
}

/// Writes the bytes to the disk: a file gets its name only then, so that it is complete also after a loss of power.
/// Returns an error, empty on success.
std::string fill(int descriptor, std::string_view bytes, const Access& access) {
  std::string wrong = write_bytes(descriptor, bytes);
  if (!wrong.empty()) return wrong;
  if (!access.give_to(descriptor)) return cannot_be_written(errno);
  const bool kept = ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS;
  return kept ? std::string() : cannot_be_written(errno);
}

/// Writes a file that gets its name only when it is complete, so that nothing remains if the program is
/// killed before. False if the file system does not support files without a name.
bool write_unnamed(const fs::path& file, std::string_view bytes, const Access& access,
                   std::string& wrong) {
  const Descriptor open_file(
      ::open(folder_of(file).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, access.mode()));
  if (!open_file.is_open()) return false;
  wrong = fill(open_file.number(), bytes, access);
  const std::string unnamed = fmt::format("/proc/self/fd/{}", open_file.number());
  return !wrong.empty() ||
         ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, file.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// Fills the room from a file and returns an error, empty on success.
std::string read_bytes(int descriptor, std::span<std::byte> room) {
  while (!room.empty()) {
    const ssize_t got = ::read(descriptor, room.data(), room.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return "cannot be read: " + message_of(errno);
    if (got == 0) return "became shorter while it was read";
    room = room.subspan(static_cast<std::size_t>(got));
  }
  return {};
}

/// The same with a name from the beginning, of a file that does not exist yet.
std::string write_named(const fs::path& file, std::string_view bytes, const Access& access) {
  Descriptor open_file(
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, access.mode()));
  if (!open_file.is_open()) return cannot_be_written(errno);
  std::string wrong = fill(open_file.number(), bytes, access);
  if (!open_file.close() && wrong.empty()) wrong = cannot_be_written(errno);
  if (!wrong.empty()) ::unlink(file.c_str());
  return wrong;
}

/// The file itself, at the end of symbolic links; it does not have to exist.
fs::path target_of(fs::path file) {
  constexpr int kMostLinks = 40;  // as Linux has it; with more, writing fails
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
    file = file.parent_path() / fs::read_symlink(file, error);
  }
  return file;
}

/// So that the new name is on the disk, too. Some file systems cannot do this; the file is complete either way.
void keep_names(const fs::path& folder) {
  const Descriptor open_folder(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (open_folder.is_open()) ::fsync(open_folder.number());
}

/// Writes a temporary file and gives it the name of the target, or removes it.
std::string replace_file(const fs::path& target, std::string_view bytes) {
  const auto temporary = temporary_name(target);
  if (!temporary) return temporary.error();
  const Access access = access_of(target);
  std::string wrong;
  if (!write_unnamed(*temporary, bytes, access, wrong))
    wrong = write_named(*temporary, bytes, access);
  if (!wrong.empty()) return wrong;
  std::error_code error;
  fs::rename(*temporary, target, error);
  if (!error) {
    keep_names(folder_of(target));
    return {};
  }
  wrong = "cannot be written: " + error.message();
  fs::remove(*temporary, error);
  return wrong;
}

}  // namespace

Expected<std::string, Error> read_file(const fs::path& file, std::size_t largest) {
  try {
    auto pieces = FilePieces::open(file, largest);
    if (!pieces) return Unexpected<Error>(pieces.error());
    std::string bytes(pieces->size(), '\0');
    bytes.resize(pieces->read(bytes));
    if (pieces->failed()) return failure_of(file, "cannot be read");
    return bytes;
  } catch (const std::bad_alloc&) {
    return failure_of(file, "not enough memory for this file");
  }
}

Expected<FilePieces, Error> FilePieces::open(const fs::path& file, std::size_t largest) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) return failure_of(file, "cannot be opened: " + error.message());
  if (!fs::is_regular_file(status)) return failure_of(file, "not a regular file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return failure_of(file, "cannot be opened: " + error.message());
  if (size > largest) {
    return failure_of(file, fmt::format("too large: {} bytes, the limit is {}", size, largest));
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return failure_of(file, "cannot be opened: " + message_of(errno));
  return FilePieces(std::move(stream), static_cast<std::size_t>(size));
}

FilePieces::FilePieces(std::ifstream stream, std::size_t size)
    : stream_(std::move(stream)), size_(size) {}

std::string_view FilePieces::next() {
  piece_.resize(std::min(size_, kFilePiece));
  return std::string_view(piece_).substr(0, read(piece_));
}

std::size_t FilePieces::read(std::span<char> room) {
  stream_.read(room.data(), static_cast<std::streamsize>(room.size()));
  return static_cast<std::size_t>(stream_.gcount());
}

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

Expected<std::string, Error> read_stream(const fs::path& file, std::size_t largest) {
  const auto failure = [&file](const std::string& what) {
    return file_failure(stream_name(file), 0, what);
  };
  const Descriptor stream(is_standard_input(file) ? STDIN_FILENO
                                                  : ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (!stream.is_open()) return failure("cannot be opened: " + message_of(errno));
  std::string bytes;
  std::size_t size = 0;
  for (;;) {
    if (bytes.size() - size < kStreamPiece) bytes.resize(std::max(2 * bytes.size(), kStreamPiece));
    const ssize_t got = ::read(stream.number(), bytes.data() + size, kStreamPiece);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failure("cannot be read: " + message_of(errno));
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
    if (size > largest) return failure(fmt::format("too large: the limit is {} bytes", largest));
  }
  bytes.resize(size);
  return bytes;
}

Expected<void, Error> write_file(const fs::path& file, std::string_view bytes) {
  const fs::path target = target_of(file);
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (!fs::status_known(status)) return failure_of(file, "cannot be written: " + error.message());
  const bool is_device = fs::exists(status) && !fs::is_regular_file(status);
  const std::string wrong = is_device ? write_bytes(target, bytes) : replace_file(target, bytes);
  if (!wrong.empty()) return failure_of(file, wrong);
  return {};
}

Expected<void, Error> write_index(const fs::path& file, const IndexBytes& index) {
  const auto bytes = index.bytes();
  return write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Expected<IndexBytes, Error> open_index(const fs::path& file) {
  const Descriptor index(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status{};
  if (!index.is_open() || ::fstat(index.number(), &status) != 0)
    return failure_of(file, message_of(errno));
  if (!S_ISREG(status.st_mode)) return failure_of(file, "not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return failure_of(file, "the file is empty; expected an index");
  try {
    std::string wrong;
    IndexBytes bytes = IndexBytes::written(
        size, [&](std::span<std::byte> room) { wrong = read_bytes(index.number(), room); });
    if (!wrong.empty()) return failure_of(file, wrong);
    return bytes;
  } catch (const std::bad_alloc&) {
    return failure_of(file, fmt::format("not enough memory for an index of {} bytes", size));
  }
}

}  // namespace wend
