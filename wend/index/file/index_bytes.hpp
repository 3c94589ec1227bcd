#pragma once

// IndexBytes: the bytes of an index as they are in its file, in memory. Immutable and cheap to copy:
// copies share the bytes, also between threads.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/map/bit_grid.hpp"

namespace wend {

class WEND_API IndexBytes {
 public:
  /// The alignment of the bytes and of each section: a cache line.
  static constexpr std::size_t kAlignment = 64;

  /// No bytes.
  IndexBytes() = default;

  /// Bytes that live as long as their owner. They begin at a multiple of kAlignment.
  IndexBytes(std::shared_ptr<const void> owner, std::span<const std::byte> bytes)
      : owner_(std::move(owner)), bytes_(bytes) {}

  /// A copy in memory.
  static IndexBytes copy_of(std::span<const std::byte> bytes);

  /// `size` new bytes, which write(std::span<std::byte>) sets.
  template <class Write>
  static IndexBytes written(std::size_t size, Write&& write) {
    if (size == 0) return {};
    std::shared_ptr<std::byte> memory = memory_for(size);
    const std::span<std::byte> bytes(memory.get(), size);
    std::forward<Write>(write)(bytes);
    return {std::move(memory), bytes};
  }

  /// All bytes of the file. Valid as long as a copy of this object lives.
  std::span<const std::byte> bytes() const { return bytes_; }
  /// The number of bytes.
  std::size_t size() const { return bytes_.size(); }

 private:
  static std::shared_ptr<std::byte> memory_for(std::size_t size);

  std::shared_ptr<const void> owner_;
  std::span<const std::byte> bytes_;
};

/// Where a section of an index file lies.
struct IndexSection {
  std::uint64_t offset = 0;  // from the beginning of the file
  std::uint64_t bytes = 0;   // its length
};

/// The beginning of an index file. It identifies the index and the map, and shows whether the file is
/// complete.
///
/// The header is followed by sections, each an array of numbers (little-endian) that begins at a
/// multiple of IndexBytes::kAlignment; each kind of index defines the contents of its sections. The
/// checksum covers all bytes after it.
struct WEND_API IndexHeader {
  /// The first bytes of every index file.
  static constexpr std::array<char, 8> kMagic{'w', 'e', 'n', 'd', '-', 'i', 'd', 'x'};
  static constexpr std::uint32_t kFormat = 1;       // of this header
  static constexpr std::size_t kMostSections = 26;  // of a file
  static constexpr std::size_t kLongestName = 32;   // bytes of a planner's name

  std::array<char, 8> magic = kMagic;               // kMagic, if the file is an index
  std::uint64_t checksum = 0;                       // of all bytes behind it
  std::uint32_t format = kFormat;                   // kFormat, if this version of wend can read it
  std::uint32_t version = 0;                        // of the planner's sections
  std::array<char, kLongestName> planner{};         // padded with zeros
  std::int32_t width = 0;                           // of the map, in cells
  std::int32_t height = 0;                          // of the map, in cells
  std::uint64_t passable_cells = 0;                 // how many the free space has
  std::uint64_t map_hash = 0;                       // of the passable cells
  std::uint64_t bytes = 0;                          // of the whole file
  std::uint64_t sections = 0;                       // how many entries of `table` are used
  std::array<IndexSection, kMostSections> table{};  // where the sections lie

  /// The name without its padding.
  std::string_view planner_name() const;
};

/// A hash of the passable cells: two different maps have the same hash with a probability of 2^-64.
WEND_API std::uint64_t map_hash(const BitGrid& passable);

/// For `return`: index_mismatch, with what is wrong and "index" as Error::where.
inline Unexpected<Error> index_failure(std::string what) {
  return failure(Status::index_mismatch, std::move(what), "index");
}

/// Returns the header of a complete file (its sections lie within the file and the checksum is right),
/// or index_mismatch. O(bytes).
WEND_API Expected<IndexHeader, Error> read_index_header(std::span<const std::byte> bytes);

/// Why the index does not match a map; empty if it matches.
WEND_API std::string index_fault(const IndexHeader& header, std::string_view planner,
                                 std::uint32_t version, const BitGrid& passable);

/// The file of an index.
namespace index_file {

/// The checksum of all bytes after the checksum field.
WEND_API std::uint64_t checksum_of(std::span<const std::byte> file);

}  // namespace index_file

}  // namespace wend
