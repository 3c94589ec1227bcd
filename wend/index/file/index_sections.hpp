#pragma once

// IndexReader: the sections of an index, read in place.
//
// An opened index is complete and belongs to this map, planner and version. The code that reads the
// sections checks the references between them, so that no file can make it read out of bounds.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "wend/base/expected.hpp"
#include "wend/index/file/index_bytes.hpp"

namespace wend {

class IndexReader {
 public:
  /// Returns a reader, or why the index does not match (Status::index_mismatch).
  static Expected<IndexReader, Error> open(IndexBytes index, std::string_view planner,
                                           std::uint32_t version, const BitGrid& passable);

  std::size_t sections() const { return static_cast<std::size_t>(header_.sections); }

  /// The section with this number, counted in the order of add(); nullopt if it does not exist or is not
  /// an array of T. It is valid as long as the index.
  template <class T>
  std::optional<std::span<const T>> section(std::size_t number) const {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= IndexBytes::kAlignment);
    if (number >= sections() || header_.table[number].bytes % sizeof(T) != 0) return std::nullopt;
    const IndexSection& where = header_.table[number];
    const std::byte* const begin = index_.bytes().data() + where.offset;
    return std::span<const T>(reinterpret_cast<const T*>(begin), where.bytes / sizeof(T));
  }

  const IndexBytes& index() const { return index_; }

 private:
  IndexReader(IndexBytes index, const IndexHeader& header)
      : index_(std::move(index)), header_(header) {}

  IndexBytes index_;
  IndexHeader header_;
};

// IndexWriter: assembles an index from its sections.
//
//   wend::IndexWriter writer("my_planner", 1, space.passable());
//   writer.add(std::span<const std::uint32_t>(offsets));
//   const wend::IndexBytes index = writer.finish();

class IndexWriter {
 public:
  /// `version` is the version of the sections. The name has at most IndexHeader::kLongestName letters.
  IndexWriter(std::string_view planner, std::uint32_t version, const BitGrid& passable);

  /// Appends a section: numbers, or structs of numbers without padding.
  template <class T>
  void add(std::span<const T> section) {
    static_assert(std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T>);
    add_bytes(std::as_bytes(section));
  }

  /// Call it once, at the end.
  IndexBytes finish();

 private:
  void add_bytes(std::span<const std::byte> section);

  IndexHeader header_;
  std::vector<std::byte> file_;
};

}  // namespace wend
