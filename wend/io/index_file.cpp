#include "wend/io/index_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string_view>

#include "wend/io/files.hpp"

namespace wend {
namespace {

/// A file that is open for as long as this lives.
class OpenIndexFile {
 public:
  explicit OpenIndexFile(const std::filesystem::path& file)
      : descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~OpenIndexFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenIndexFile(const OpenIndexFile&) = delete;
  OpenIndexFile& operator=(const OpenIndexFile&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

Unexpected<IoError> system_failure(const std::filesystem::path& file) {
  return io_failure(file.string(), 0, std::strerror(errno));
}

}  // namespace

Expected<void, IoError> write_index(const std::filesystem::path& file, const IndexBytes& index) {
  const auto bytes = index.bytes();
  return write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Expected<IndexBytes, IoError> open_index(const std::filesystem::path& file) {
  const OpenIndexFile open_file(file);
  struct stat status{};
  if (open_file.descriptor() < 0 || ::fstat(open_file.descriptor(), &status) != 0) {
    return system_failure(file);
  }
  if (!S_ISREG(status.st_mode)) return io_failure(file.string(), 0, "it is not a file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return io_failure(file.string(), 0, "it is empty");
  void* const address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, open_file.descriptor(), 0);
  if (address == MAP_FAILED) return system_failure(file);
  std::shared_ptr<const void> mapping(
      address, [size](const void* begin) { ::munmap(const_cast<void*>(begin), size); });
  return IndexBytes(std::move(mapping), {static_cast<const std::byte*>(address), size});
}

}  // namespace wend
