#include "wend/index/index_bytes.hpp"

#include <array>
#include <cstring>
#include <vector>

namespace wend {
namespace {

struct alignas(IndexBytes::kAlignment) Line {
  std::array<std::byte, IndexBytes::kAlignment> bytes{};
};

}  // namespace

IndexBytes IndexBytes::copy_of(std::span<const std::byte> bytes) {
  if (bytes.empty()) return {};
  const auto lines =
      std::make_shared<std::vector<Line>>((bytes.size() + kAlignment - 1) / kAlignment);
  auto* const begin = reinterpret_cast<std::byte*>(lines->data());
  std::memcpy(begin, bytes.data(), bytes.size());
  return {lines, {begin, bytes.size()}};
}

}  // namespace wend
