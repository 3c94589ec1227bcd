#include "wend/base/number_table.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "wend/base/random.hpp"

namespace wend {
namespace {

/// Many rounds of random keys against a map of the standard library. With stamps of 8 bits they run out, and keys that
/// were there 256 rounds before must not come back.
template <class Stamp>
void holds_what_a_map_holds(int rounds) {
  using Table = NumberTable<Stamp>;
  Table table;
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Random random(static_cast<std::uint64_t>(round) + 1);
    table.clear();
    std::map<std::uint64_t, std::uint32_t> model;
    const int keys = round % 10 == 0 ? 3000 : 20;
    const auto spread = static_cast<unsigned>(random.between(0, 50));
    for (int i = 0; i < keys; ++i) {
      const std::uint64_t key = static_cast<std::uint64_t>(random.between(0, keys)) << spread;
      std::uint32_t& number = table[key];
      const auto known = model.find(key);
      ASSERT_EQ(number, known == model.end() ? Table::kNone : known->second);
      number = model[key] = static_cast<std::uint32_t>(i);
    }
    for (const auto& [key, number] : model) ASSERT_EQ(table[key], number);
  }
}

TEST(NumberTable, HoldsWhatAMapHolds) { holds_what_a_map_holds<std::uint32_t>(30); }
TEST(NumberTable, StartsAgainWhenItsStampsRunOut) { holds_what_a_map_holds<std::uint8_t>(600); }

}  // namespace
}  // namespace wend
