#include "wend/base/copy_on_write.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wend {
namespace {

using Text = CopyOnWrite<std::string>;

TEST(CopyOnWrite, ChangesOneCopyOnly) {
  Text text(std::in_place, "map");
  const Text other = text;
  EXPECT_EQ(&*text, &*other) << "copies share the value";
  text.change() += "s";
  EXPECT_EQ(*text, "maps");
  EXPECT_EQ(*other, "map");
}

TEST(CopyOnWrite, ChangesInPlaceWhatNobodyShares) {
  Text text(std::in_place, 100, 'x');
  const std::string* const before = &*text;
  {
    const Text dropped = text;
  }
  text.change() += "y";
  EXPECT_EQ(&*text, before);
  EXPECT_EQ(text->size(), 101U);
}

}  // namespace
}  // namespace wend
