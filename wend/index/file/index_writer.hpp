#pragma once

// IndexWriter: puts the sections of an index together.
//
//   wend::IndexWriter writer("my_planner", 1, space.passable());
//   writer.add(std::span<const std::uint32_t>(offsets));
//   const wend::IndexBytes index = writer.finish();

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "wend/index/file/index_bytes.hpp"
#include "wend/index/file/index_header.hpp"

namespace wend {

class IndexWriter {
 public:
  /// `version` is that of the sections. The name has at most IndexHeader::kLongestName letters.
  IndexWriter(std::string_view planner, std::uint32_t version, const BitGrid& passable);

  /// The next section: numbers, or structs of numbers without gaps.
  template <class T>
  void add(std::span<const T> section) {
    static_assert(std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T>);
    add_bytes(std::as_bytes(section));
  }

  /// Once, at the end.
  IndexBytes finish();

 private:
  void add_bytes(std::span<const std::byte> section);

  IndexHeader header_;
  std::vector<std::byte> file_;
};

}  // namespace wend
