#include "bench/measure/markdown_table.hpp"

#include <gtest/gtest.h>

namespace wend {
namespace {

TEST(MarkdownTable, AlignsColumnsAndEscapesBars) {
  MarkdownTable table({{"planner"}, {"time, µs", Align::right}});
  table.add({"`a|b`", "12"});
  table.add({"", "**3**"});
  EXPECT_EQ(table.text(),
            "| planner | time, µs |\n"
            "|---|---:|\n"
            "| `a\\|b` | 12 |\n"
            "|  | **3** |\n");
}

}  // namespace
}  // namespace wend
