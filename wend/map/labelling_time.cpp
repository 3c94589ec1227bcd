#include "wend/map/labelling_time.hpp"

#include "wend/map/count_bits.hpp"
#include "wend/map/word_sample.hpp"

namespace wend {

std::uint64_t labelling_time(const BitGrid& cells) {
  // Measured: of a map of rooms 0.3 ns a cell, of a maze or noise 3.
  constexpr std::uint64_t kPerWord = 13;
  constexpr std::uint64_t kPerRun = 13;
  std::uint64_t runs = 0;
  visit_sample(cells, [&](int y, std::size_t i, std::uint64_t /*on_map*/) {
    const std::uint64_t word = cells.row_words(y)[i];
    runs += static_cast<std::uint64_t>(count_bits(word & ~(word << 1U)));
  });
  const auto words = static_cast<std::uint64_t>(cells.width() / 64 + 1) *
                     static_cast<std::uint64_t>(cells.height());
  return words * (kPerWord + kPerRun * runs / kSampledWords);
}

}  // namespace wend
