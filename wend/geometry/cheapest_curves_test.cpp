#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"

namespace wend {
namespace {

constexpr CurveCosts kLengths{};

double number_between(double least, double greatest) {
  constexpr int kSteps = 1000000;
  return least + (greatest - least) * *rc::gen::inRange(0, kSteps + 1) / kSteps;
}

Pose random_pose(double size) {
  const double x = number_between(-size, size);
  const double y = number_between(-size, size);
  const double heading = number_between(-7, 7);
  return {x, y, heading};
}

CurveCosts random_costs() {
  const double reverse = number_between(0, 5);
  const double turn = number_between(0, 3);
  const double gear_change = number_between(0, 4);
  return {reverse, turn, gear_change};
}

double gap(const Pose& a, const Pose& b) {
  return std::max(distance(a.point(), b.point()),
                  std::abs(normalized_angle(a.heading - b.heading)));
}

std::vector<Curve> words_of(int (*words)(const Pose&, const Pose&, double, const CurveCosts&,
                                         double, std::span<Curve>),
                            const Pose& from, const Pose& to, double radius,
                            const CurveCosts& costs = kLengths, double bound = kNoBound) {
  std::vector<Curve> out(48);
  out.resize(static_cast<std::size_t>(words(from, to, radius, costs, bound, out)));
  return out;
}

bool is_close(double a, double b) { return std::abs(a - b) <= 1e-12 * std::max(a, b); }

/// The words of Reeds and Shepp that begin with an arc to the left driven ahead. The others are their mirror
/// images, with all gears exchanged or not.
struct Family {
  std::string_view turns;
  std::string_view gears;
};
constexpr std::array<Family, 12> kFamilies{{{"LSL", "+++"},
                                            {"LSR", "+++"},
                                            {"LRL", "+-+"},
                                            {"LRL", "++-"},
                                            {"LRL", "+--"},
                                            {"LRLR", "++--"},
                                            {"LRLR", "+--+"},
                                            {"LRSL", "+---"},
                                            {"LRSR", "+---"},
                                            {"LSRL", "+++-"},
                                            {"LSLR", "+++-"},
                                            {"LRSLR", "+---+"}}};

/// A word with random lengths. Radius 1.
std::vector<CurvePiece> random_word(const Family& family, bool mirrored, bool exchanged) {
  const std::size_t count = family.turns.size();
  const bool has_line = family.turns.find('S') != std::string_view::npos;
  const double full = 2 * kPi - 0.01;
  const double first = number_between(0.01, full);
  const double last = number_between(0.01, full);
  const double line = number_between(0.01, 6);
  const double widest = count == 3 ? kPi : family.gears == "++--" ? kPi / 3 : kPi / 2;
  const double arc = has_line ? kPi / 2 : number_between(0.01, widest - 0.01);
  std::vector<CurvePiece> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const char letter = family.turns[i];
    const int side = letter == 'S' ? 0 : (letter == 'L') == mirrored ? -1 : 1;
    const double length = i == 0 ? first : i + 1 == count ? last : letter == 'S' ? line : arc;
    const bool ahead = (family.gears[i] == '+') != exchanged;
    pieces.push_back({ahead ? length : -length, static_cast<Turn>(side)});
  }
  return pieces;
}

/// Calls `check` with a random drive along each of the 48 words.
template <class Check>
void for_each_word(Check&& check) {
  for (const Family& family : kFamilies) {
    for (const bool mirrored : {false, true}) {
      for (const bool exchanged : {false, true}) check(random_word(family, mirrored, exchanged));
    }
  }
}

Pose driven_from(Pose pose, std::span<const CurvePiece> pieces, double radius) {
  for (const CurvePiece& piece : pieces) pose = end_of(piece, pose, radius);
  return pose;
}

bool is_near(std::span<const CurvePiece> a, std::span<const CurvePiece> b) {
  return std::ranges::equal(a, b, [](const CurvePiece& x, const CurvePiece& y) {
    return x.turn == y.turn && std::abs(x.length - y.length) < 1e-6;
  });
}

RC_GTEST_PROP(CheapestCurves, OfAllKindsEndAtTheGoal, ()) {
  const double radius = number_between(0.1, 20);
  const Pose from = random_pose(5 * radius);
  const Pose to = random_pose(5 * radius);
  for (auto* const words : {reeds_shepp_words, dubins_words, simple_words}) {
    for (const Curve& curve : words_of(words, from, to, radius)) {
      RC_ASSERT(gap(end_of(curve, from, radius), to) < 1e-9 * std::max(radius, 1.0));
      for (const CurvePiece& piece : curve.driven()) {
        RC_ASSERT(words != dubins_words || piece.length > 0);
        RC_ASSERT(piece.turn == Turn::straight ||
                  std::abs(piece.length) <= 2 * kPi * radius + 1e-9);
      }
    }
  }
}

TEST(CheapestCurves, EndAtTheGoalWhereArcsVanishOrCirclesCoincide) {
  for (int heading = 0; heading < 8; ++heading) {
    for (int x = -10; x <= 10; ++x) {
      for (int y = -10; y <= 10; ++y) {
        for (const double angle : {0.0, 1.0, kPi / 2}) {
          const Pose from{3, -2, angle};
          const Pose to{3 + x * 0.5, -2 + y * 0.5, angle + heading * kPi / 4};
          for (auto* const words : {reeds_shepp_words, dubins_words, simple_words}) {
            for (const Curve& curve : words_of(words, from, to, 1)) {
              ASSERT_LT(gap(end_of(curve, from, 1), to), 1e-9) << x << ' ' << y << ' ' << heading;
            }
          }
        }
      }
    }
  }
}

RC_GTEST_PROP(ReedsShepp, FindsEachOfItsWords, ()) {
  const double radius = number_between(0.2, 8);
  const Pose from = random_pose(9);
  for_each_word([&](std::vector<CurvePiece> word) {
    for (CurvePiece& piece : word) piece.length *= radius;
    const Pose to = driven_from(from, word, radius);
    const auto found = words_of(reeds_shepp_words, from, to, radius);
    const bool is_there = std::ranges::any_of(found, [&](const Curve& curve) {
      for (CurvePiece& piece : word) piece.length /= radius;
      Curve scaled = curve;
      for (CurvePiece& piece : scaled.pieces) piece.length /= radius;
      const bool same = is_near(scaled.driven(), word);
      for (CurvePiece& piece : word) piece.length *= radius;
      return same;
    });
    RC_ASSERT(is_there);
  });
}

RC_GTEST_PROP(ReedsShepp, IsAtMostWhatAnyOfItsWordsCosts, ()) {
  const Pose from = random_pose(9);
  const CurveCosts costs = random_costs();
  for_each_word([&](const std::vector<CurvePiece>& word) {
    const Pose to = driven_from(from, word, 1);
    RC_ASSERT(cheapest_reeds_shepp(from, to, 1, costs).cost <= cost_of(word, costs) + 1e-9);
  });
}

/// Any drive, of at most seven pieces; some of them short.
std::vector<CurvePiece> random_drive(bool reverses) {
  std::vector<CurvePiece> pieces;
  const int count = *rc::gen::inRange(1, 8);
  for (int i = 0; i < count; ++i) {
    const double most = *rc::gen::element(0.1, 1.0, 4.0);
    const double length = number_between(reverses ? -most : 0, most);
    const int side = *rc::gen::inRange(-1, 2);
    pieces.push_back({length, static_cast<Turn>(side)});
  }
  return pieces;
}

RC_GTEST_PROP(ReedsShepp, IsShorterThanAnyDrive, ()) {
  const Pose from = random_pose(9);
  for (int i = 0; i < 20; ++i) {
    const auto drive = random_drive(true);
    const Pose to = driven_from(from, drive, 1);
    RC_ASSERT(cheapest_reeds_shepp(from, to, 1).cost <= cost_of(drive, kLengths) + 1e-9);
  }
}

RC_GTEST_PROP(Dubins, IsShorterThanAnyDriveAhead, ()) {
  const Pose from = random_pose(9);
  for (int i = 0; i < 20; ++i) {
    const auto drive = random_drive(false);
    const Pose to = driven_from(from, drive, 1);
    RC_ASSERT(cheapest_dubins(from, to, 1).cost <= cost_of(drive, kLengths) + 1e-9);
  }
}

RC_GTEST_PROP(CheapestCurves, AreAtLeastAsLongAsTheCurvesWithFewerRules, ()) {
  const double radius = number_between(0.1, 5);
  const Pose from = random_pose(9);
  const Pose to = random_pose(9);
  const double dubins = cheapest_dubins(from, to, radius).length();
  const double reeds_shepp = cheapest_reeds_shepp(from, to, radius).length();
  RC_ASSERT(dubins >= reeds_shepp - 1e-9);
  RC_ASSERT(reeds_shepp >= distance(from.point(), to.point()) - 1e-9);
  RC_ASSERT(reeds_shepp >= radius * std::abs(normalized_angle(to.heading - from.heading)) - 1e-9);
}

RC_GTEST_PROP(ReedsShepp, IsTheSameBackwardsMirroredMovedAndWithGearsExchanged, ()) {
  const Pose from = random_pose(9);
  const Pose to = random_pose(9);
  const double turn = number_between(0.5, 2);
  const double gear_change = number_between(0, 3);
  const CurveCosts costs{1, turn, gear_change};
  const double cost = cheapest_reeds_shepp(from, to, 1, costs).cost;
  const auto is_same = [&](const Pose& begin, const Pose& end, double radius = 1) {
    const CurveCosts scaled{1, turn, gear_change * radius};
    return std::abs(cheapest_reeds_shepp(begin, end, radius, scaled).cost / radius - cost) < 1e-8;
  };
  RC_ASSERT(is_same(to, from));
  const auto mirrored = [](const Pose& pose) { return Pose{pose.x, -pose.y, -pose.heading}; };
  RC_ASSERT(is_same(mirrored(from), mirrored(to)));
  const auto turned = [](const Pose& pose) { return Pose{pose.x, pose.y, pose.heading + kPi}; };
  RC_ASSERT(is_same(turned(from), turned(to)));
  const auto moved = [](const Pose& pose) {
    return Pose{3 - pose.y, 7 + pose.x, pose.heading + kPi / 2 + 4 * kPi};
  };
  RC_ASSERT(is_same(moved(from), moved(to)));
  const auto scaled = [](const Pose& pose) { return Pose{3 * pose.x, 3 * pose.y, pose.heading}; };
  RC_ASSERT(is_same(scaled(from), scaled(to), 3));
}

RC_GTEST_PROP(CheapestCurves, AreTheFirstOfAllWordsWithAnyBound, ()) {
  const Pose from = random_pose(5);
  const Pose to = random_pose(5);
  const CurveCosts costs = random_costs();
  const auto all = words_of(reeds_shepp_words, from, to, 1, costs);
  RC_ASSERT(std::ranges::is_sorted(all, {}, &Curve::cost));
  const Curve cheapest = cheapest_reeds_shepp(from, to, 1, costs);
  RC_ASSERT(is_close(cheapest.cost, all.front().cost));

  const auto of = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(all.size())));
  const double bound = all[of].cost * (1 - 1e-9);
  const auto below = words_of(reeds_shepp_words, from, to, 1, costs, bound);
  const auto end = std::ranges::lower_bound(all, bound, {}, &Curve::cost);
  RC_ASSERT(std::ranges::equal(below, std::ranges::subrange(all.begin(), end), is_close,
                               &Curve::cost, &Curve::cost));
  RC_ASSERT(cheapest_reeds_shepp(from, to, 1, costs, bound).exists() == !below.empty());

  std::array<Curve, 3> few;
  RC_ASSERT(reeds_shepp_words(from, to, 1, costs, kNoBound, few) == 3);
  RC_ASSERT(std::ranges::equal(few, std::span(all).first(3), is_close, &Curve::cost, &Curve::cost));
}

RC_GTEST_PROP(CheapestCurves, CostWhatTheirPiecesCost, ()) {
  const Pose from = random_pose(5);
  const Pose to = random_pose(5);
  const CurveCosts costs = random_costs();
  for (auto* const words : {reeds_shepp_words, dubins_words, simple_words}) {
    for (const Curve& curve : words_of(words, from, to, 1, costs)) {
      RC_ASSERT(curve.cost == cost_of(curve.driven(), costs));
    }
  }
}

RC_GTEST_PROP(SimpleWords, AreTheWordsOfReedsAndSheppWithOneGearAndALine, ()) {
  const Pose from = random_pose(9);
  const Pose to = random_pose(9);
  const auto all = words_of(reeds_shepp_words, from, to, 1);
  for (const Curve& curve : words_of(simple_words, from, to, 1)) {
    RC_ASSERT(curve.gear_changes() == 0);
    RC_ASSERT(std::ranges::find(all, curve) != all.end());
  }
}

TEST(ReedsShepp, IsContinuousWhereArcsVanish) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const Pose to{random.between(-10, 10) * 0.5, random.between(-10, 10) * 0.5,
                  random.between(0, 7) * kPi / 4};
    const double cost = cheapest_reeds_shepp({0, 0, 0}, to, 1).cost;
    const double x = to.x + 1e-12 * (random.uniform() - 0.5);
    const double y = to.y + 1e-12 * (random.uniform() - 0.5);
    const double heading = to.heading + 1e-12 * (random.uniform() - 0.5);
    const double nearby = cheapest_reeds_shepp({0, 0, 0}, {x, y, heading}, 1).cost;
    ASSERT_NEAR(nearby, cost, 1e-5) << to.x << ' ' << to.y << ' ' << to.heading;
  }
}

// This number was computed once. Where a platform has another, its plans differ from those of the rest.
TEST(CheapestCurves, HaveTheSameBitsEverywhere) {
  Random random(2);
  std::uint64_t bits = 0;
  for (int i = 0; i < 5000; ++i) {
    const double x = random.between(-400, 400) / 64.0;
    const double y = random.between(-400, 400) / 64.0;
    const double heading = random.between(-400, 400) / 64.0;
    const Curve curve = cheapest_reeds_shepp({0, 0, 0.25}, {x, y, heading}, 1, {2, 1.25, 0.5});
    bits = std::rotl(bits, 7) ^ std::bit_cast<std::uint64_t>(curve.cost);
    bits = std::rotl(bits, 7) ^ std::bit_cast<std::uint64_t>(end_of(curve, {0, 0, 0.25}, 1).x);
  }
  EXPECT_EQ(bits, 2652253989111638959U);
}

TEST(ReedsShepp, HasKnownLengths) {
  const auto length = [](const Pose& to) {
    return cheapest_reeds_shepp({0, 0, 0}, to, 1).length();
  };
  EXPECT_NEAR(length({5, 0, 0}), 5, 1e-12);
  EXPECT_NEAR(length({-5, 0, 0}), 5, 1e-12);
  EXPECT_NEAR(length({1, 1, kPi / 2}), kPi / 2, 1e-12);
  EXPECT_NEAR(length({0, 2, kPi}), kPi, 1e-12);
  EXPECT_NEAR(length({0, 0, kPi}), kPi, 1e-12);  // three arcs, each of a sixth of a turn
  EXPECT_NEAR(length({0, 4, kPi}), kPi + 2, 1e-12);
}

TEST(Dubins, HasKnownLengths) {
  const auto length = [](const Pose& to) { return cheapest_dubins({0, 0, 0}, to, 1).length(); };
  EXPECT_NEAR(length({5, 0, 0}), 5, 1e-12);
  EXPECT_NEAR(length({1, -1, -kPi / 2}), kPi / 2, 1e-12);
  EXPECT_NEAR(length({0, 0, kPi}), 7 * kPi / 3,
              1e-12);  // a sixth, five sixths and a sixth of a turn
  EXPECT_NEAR(length({-4, 0, 0}), 2 * kPi + 4, 1e-12);
  EXPECT_NEAR(length({0, 4, kPi}), kPi + 2, 1e-12);
}

TEST(Dubins, DoesNotDependOnThePriceOfReverse) {
  const Pose to{-3, 1, 2};
  EXPECT_EQ(cheapest_dubins({0, 0, 0}, to, 1, {.reverse = 7, .gear_change = 9}),
            cheapest_dubins({0, 0, 0}, to, 1));
}

// No shortest curve has an arc of more than half a turn, but without such arcs the costs of poses next to each
// other would differ much.
TEST(ReedsShepp, DrivesALoopWhereReverseIsExpensive) {
  const CurveCosts costs{.reverse = 10};
  for (const double heading : {-0.01, 0.0, 0.01}) {
    const Curve loop = cheapest_reeds_shepp({0, 0, 0}, {-5, 0, heading}, 1, costs);
    EXPECT_NEAR(loop.cost, 2 * kPi + 5, 0.02);
    EXPECT_EQ(loop.gear_changes(), 0);
  }
}

TEST(ReedsShepp, WeighsChangesOfGear) {
  const Pose turned{0, 0, kPi};
  const Curve shortest = cheapest_reeds_shepp({0, 0, 0}, turned, 1);
  const Curve ahead = cheapest_reeds_shepp({0, 0, 0}, turned, 1, {.gear_change = 100});
  EXPECT_EQ(shortest.gear_changes(), 2);
  EXPECT_EQ(ahead.gear_changes(), 0);
  EXPECT_GT(ahead.length(), shortest.length());
}

}  // namespace
}  // namespace wend
