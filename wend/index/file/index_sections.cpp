#include "wend/index/file/index_sections.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace wend {

Expected<IndexReader, Error> IndexReader::open(IndexBytes index, std::string_view planner,
                                               std::uint32_t version, const BitGrid& passable) {
  const auto header = read_index_header(index.bytes());
  if (!header) return Unexpected<Error>(header.error());
  std::string fault = index_fault(*header, planner, version, passable);
  if (!fault.empty()) return index_failure(std::move(fault));
  return IndexReader(std::move(index), *header);
}

IndexWriter::IndexWriter(std::string_view planner, std::uint32_t version, const BitGrid& passable)
    : file_(sizeof(IndexHeader)) {
  assert(planner.size() <= header_.planner.size());
  std::copy(planner.begin(), planner.end(), header_.planner.begin());
  header_.version = version;
  header_.width = passable.width();
  header_.height = passable.height();
  header_.passable_cells = passable.count();
  header_.map_hash = map_hash(passable);
}

void IndexWriter::add_bytes(std::span<const std::byte> section) {
  assert(header_.sections < IndexHeader::kMostSections);
  constexpr std::size_t kAlignment = IndexBytes::kAlignment;
  file_.resize((file_.size() + kAlignment - 1) / kAlignment * kAlignment);
  header_.table[header_.sections++] = {file_.size(), section.size()};
  file_.insert(file_.end(), section.begin(), section.end());
}

IndexBytes IndexWriter::finish() {
  header_.bytes = file_.size();
  std::memcpy(file_.data(), &header_, sizeof header_);
  header_.checksum = index_file::checksum_of(file_);
  std::memcpy(file_.data(), &header_, sizeof header_);
  return IndexBytes::copy_of(file_);
}

}  // namespace wend
