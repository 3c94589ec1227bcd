#include "wend/base/lazy.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wend {
namespace {

TEST(Lazy, IsMadeOnceWhenAskedFor) {
  const Lazy<std::string> text;
  int made = 0;
  const auto make = [&] {
    ++made;
    return std::string("map");
  };
  EXPECT_FALSE(text.made());
  EXPECT_EQ(made, 0);
  EXPECT_EQ(text.get(make), "map");
  EXPECT_EQ(&text.get(make), &text.get(make));
  EXPECT_TRUE(text.made());
  EXPECT_EQ(made, 1);
}

TEST(Lazy, IsCopiedWithWhatHasBeenMade) {
  const auto make = [] { return std::string("again"); };
  const Lazy<std::string> unasked;
  const Lazy<std::string> copy_of_unasked(unasked);
  EXPECT_FALSE(copy_of_unasked.made());
  const Lazy<std::string> text;
  text.get([] { return std::string("first"); });
  Lazy<std::string> copy(text);
  EXPECT_EQ(copy.get(make), "first");
  copy.changeable()->append(" changed");
  EXPECT_EQ(copy.get(make), "first changed");
  EXPECT_EQ(text.get(make), "first");
}

TEST(Lazy, IsMadeAgainOnceItWasForgotten) {
  Lazy<std::string> text;
  EXPECT_EQ(text.changeable(), nullptr);
  text.get([] { return std::string("first"); });
  text.reset();
  EXPECT_FALSE(text.made());
  EXPECT_EQ(text.get([] { return std::string("second"); }), "second");
}

}  // namespace
}  // namespace wend
