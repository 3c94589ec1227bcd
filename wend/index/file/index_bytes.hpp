#pragma once

// IndexBytes: the bytes of an index as they stand in its file, in memory or mapped. Immutable and
// cheap to copy: copies share them, also between threads.

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace wend {

class IndexBytes {
 public:
  /// Where the bytes begin, and where each of their sections does: a cache line.
  static constexpr std::size_t kAlignment = 64;

  IndexBytes() = default;

  /// Bytes that live as long as their owner. They begin at a multiple of kAlignment.
  IndexBytes(std::shared_ptr<const void> owner, std::span<const std::byte> bytes)
      : owner_(std::move(owner)), bytes_(bytes) {}

  /// A copy in memory.
  static IndexBytes copy_of(std::span<const std::byte> bytes);

  std::span<const std::byte> bytes() const { return bytes_; }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::shared_ptr<const void> owner_;
  std::span<const std::byte> bytes_;
};

}  // namespace wend
