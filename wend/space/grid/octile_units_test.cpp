#include "wend/space/grid/octile.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

namespace wend {
namespace {

int sign(std::int64_t number) { return (number > 0 ? 1 : 0) - (number < 0 ? 1 : 0); }

/// The sign of straight + diagonal * sqrt(2), exactly.
int sign_of_octile_length(std::int64_t straight, std::int64_t diagonal) {
  if (sign(straight) * sign(diagonal) >= 0) return sign(straight + diagonal);
  // Opposite signs: the term with the larger square decides. (No squares here exceed 2^63.)
  const int larger = sign(straight * straight - 2 * diagonal * diagonal);
  return larger > 0 ? sign(straight) : sign(diagonal);
}

template <class Cost>
std::int64_t units(std::int64_t straight, std::int64_t diagonal) {
  return straight * static_cast<std::int64_t>(OctileUnits<Cost>::kStraight) +
         diagonal * static_cast<std::int64_t>(OctileUnits<Cost>::kDiagonal);
}

template <class Cost>
class Units : public ::testing::Test {
 public:
  static constexpr auto kStraight = static_cast<std::int64_t>(OctileUnits<Cost>::kStraight);
  static constexpr auto kDiagonal = static_cast<std::int64_t>(OctileUnits<Cost>::kDiagonal);
};

using OctileCosts = ::testing::Types<std::uint32_t, std::uint64_t>;
TYPED_TEST_SUITE(Units, OctileCosts);

TYPED_TEST(Units, AreAPellPair) {
  const std::int64_t defect =
      this->kDiagonal * this->kDiagonal - 2 * this->kStraight * this->kStraight;
  EXPECT_EQ(defect * defect, 1);
}

/// Two sums of steps differ by some straight and diagonal steps; the hardest cases differ by almost
/// nothing.
TYPED_TEST(Units, CompareSumsOfStepsAsTheirTrueLengths) {
  const bool holds = rc::check([&] {
    const auto diagonal = *rc::gen::inRange<std::int64_t>(-this->kStraight + 1, this->kStraight);
    const auto nearest = static_cast<std::int64_t>(
        std::floor(-static_cast<long double>(diagonal) * std::sqrt(2.0L)));
    const auto straight = nearest + *rc::gen::inRange<std::int64_t>(-3, 5);
    RC_ASSERT(sign(units<TypeParam>(straight, diagonal)) ==
              sign_of_octile_length(straight, diagonal));
  });
  EXPECT_TRUE(holds);
}

TYPED_TEST(Units, CompareAnySmallSums) {
  for (std::int64_t straight = -300; straight <= 300; ++straight) {
    for (std::int64_t diagonal = -300; diagonal <= 300; ++diagonal) {
      ASSERT_EQ(sign(units<TypeParam>(straight, diagonal)),
                sign_of_octile_length(straight, diagonal))
          << straight << " straight and " << diagonal << " diagonal steps";
    }
  }
}

/// Where the guarantee ends: kStraight diagonal steps weigh exactly as much as kDiagonal straight
/// ones.
TYPED_TEST(Units, MeanOneLengthByOneSumUpToTheirOwnSize) {
  EXPECT_EQ(units<TypeParam>(this->kDiagonal, -this->kStraight), 0);
  EXPECT_NE(sign_of_octile_length(this->kDiagonal, -this->kStraight), 0);
}

TEST(CompactUnits, HoldPathsOfSome128000Cells) {
  EXPECT_GE(UINT32_MAX / OctileUnits<std::uint32_t>::kStraight, 128'000U);
}

}  // namespace
}  // namespace wend
