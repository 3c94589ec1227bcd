#include "wend/index/file/index_reader.hpp"

namespace wend {

Expected<IndexReader, std::string> IndexReader::open(IndexBytes index, std::string_view planner,
                                                     std::uint32_t version,
                                                     const BitGrid& passable) {
  const auto header = read_index_header(index.bytes());
  if (!header) return Unexpected<std::string>(header.error());
  std::string fault = index_fault(*header, planner, version, passable);
  if (!fault.empty()) return Unexpected<std::string>(std::move(fault));
  return IndexReader(std::move(index), *header);
}

}  // namespace wend
