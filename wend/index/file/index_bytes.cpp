#include "wend/index/file/index_bytes.hpp"

#include <bit>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace wend {
namespace {

// Huge pages have 2 MiB instead of 4 KiB, so that random reads from large tables cause fewer TLB misses.
constexpr std::size_t kHugePage = std::size_t{1} << 21U;

/// Requests huge pages; call it before the memory is first touched. It does nothing if the system has
/// none.
void ask_for_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef __linux__
  static_cast<void>(::madvise(begin, bytes, MADV_HUGEPAGE));  // failure costs only speed
#endif
}

/// Mixes words into 64 bits, each with a multiplication and a shift as at the end of splitmix64.
class Hash {
 public:
  void add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9E3779B97F4A7C15U;
    state_ ^= state_ >> 32U;
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x243F6A8885A308D3U;
};

bool lies_within(const IndexSection& section, std::uint64_t bytes) {
  return section.offset % IndexBytes::kAlignment == 0 && section.offset >= sizeof(IndexHeader) &&
         section.offset <= bytes && section.bytes <= bytes - section.offset;
}

std::string size_text(std::int64_t width, std::int64_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

std::shared_ptr<std::byte> IndexBytes::memory_for(std::size_t size) {
  const std::size_t page = size < kHugePage ? kAlignment : kHugePage;
  const std::size_t room = (size + page - 1) / page * page;
  const std::align_val_t alignment{page};
  std::shared_ptr<std::byte> memory(
      static_cast<std::byte*>(::operator new(room, alignment)),
      [alignment](std::byte* begin) { ::operator delete(begin, alignment); });
  if (page == kHugePage) ask_for_huge_pages(memory.get(), room);
  return memory;
}

IndexBytes IndexBytes::copy_of(std::span<const std::byte> bytes) {
  return written(bytes.size(), [&](std::span<std::byte> copy) {
    if (!bytes.empty()) std::memcpy(copy.data(), bytes.data(), bytes.size());
  });
}

static_assert(std::endian::native == std::endian::little, "an index lies in memory as in its file");
static_assert(sizeof(IndexHeader) % IndexBytes::kAlignment == 0);

std::string_view IndexHeader::planner_name() const {
  const std::string_view name(planner.data(), planner.size());
  return name.substr(0, name.find('\0'));
}

std::uint64_t map_hash(const BitGrid& passable) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(passable.width()));
  hash.add(static_cast<std::uint64_t>(passable.height()));
  for (int y = 0; y < passable.height(); ++y) {
    for (const std::uint64_t word : passable.row_words(y)) hash.add(word);
  }
  return hash.value();
}

std::uint64_t index_file::checksum_of(std::span<const std::byte> file) {
  const auto rest = file.subspan(offsetof(IndexHeader, checksum) + sizeof(std::uint64_t));
  Hash hash;
  std::size_t at = 0;
  for (; at + 8 <= rest.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, rest.data() + at, 8);
    hash.add(word);
  }
  std::uint64_t last = rest.size();
  for (; at < rest.size(); ++at) last = last << 8U | std::to_integer<std::uint64_t>(rest[at]);
  hash.add(last);
  return hash.value();
}

Expected<IndexHeader, Error> read_index_header(std::span<const std::byte> bytes) {
  IndexHeader header;
  if (bytes.size() < header.magic.size() ||
      std::memcmp(bytes.data(), IndexHeader::kMagic.data(), header.magic.size()) != 0) {
    return index_failure("it is not an index of wend");
  }
  if (bytes.size() < sizeof header) return index_failure("it is truncated within its header");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.format != IndexHeader::kFormat) {
    return index_failure("its format has number " + std::to_string(header.format) +
                         ", this wend reads " + std::to_string(IndexHeader::kFormat) +
                         ": build it again");
  }
  if (header.bytes != bytes.size()) {
    return index_failure("it should have " + std::to_string(header.bytes) + " bytes and has " +
                         std::to_string(bytes.size()));
  }
  if (header.checksum != index_file::checksum_of(bytes)) {
    return index_failure("it is damaged: its checksum is wrong");
  }
  if (header.sections > IndexHeader::kMostSections)
    return index_failure("it has too many sections");
  for (std::size_t i = 0; i < header.sections; ++i) {
    if (!lies_within(header.table[i], header.bytes)) {
      return index_failure("its section " + std::to_string(i) + " is outside the file");
    }
  }
  return header;
}

std::string index_fault(const IndexHeader& header, std::string_view planner, std::uint32_t version,
                        const BitGrid& passable) {
  if (header.planner_name() != planner) {
    return "it is an index for the planner " + std::string(header.planner_name()) + ", not for " +
           std::string(planner);
  }
  if (header.version != version) {
    return "it is of version " + std::to_string(header.version) + ", this wend reads version " +
           std::to_string(version) + ": build it again";
  }
  if (header.width != passable.width() || header.height != passable.height()) {
    return "it was built for a map of " + size_text(header.width, header.height) +
           " cells, this one has " + size_text(passable.width(), passable.height());
  }
  if (header.map_hash != map_hash(passable)) {
    return "it was built for another map, another robot radius, or another setting for unknown "
           "cells or the outside of the map; build it again";
  }
  return {};
}

}  // namespace wend
