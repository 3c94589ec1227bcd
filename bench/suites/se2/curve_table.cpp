#include "bench/suites/se2/curve_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "bench/measure/markdown_table.hpp"
#ifdef WEND_WITH_OMPL
#include "bench/suites/se2/ompl_curves.hpp"
#endif
#include "wend/base/parse.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/curve.hpp"

namespace wend::bench {
namespace {

struct PosePair {
  Pose from;
  Pose to;
};

std::vector<PosePair> random_pose_pairs(double size, int count) {
  Random random(1);
  const auto pose = [&] {
    const double x = size * random.uniform();
    const double y = size * random.uniform();
    return Pose{x, y, (2 * random.uniform() - 1) * kPi};
  };
  std::vector<PosePair> pairs;
  for (int i = 0; i < count; ++i) {
    const Pose from = pose();
    pairs.push_back({from, pose()});
  }
  return pairs;
}

/// Nanoseconds a call, and what all calls return.
struct Timed {
  double nanoseconds = std::numeric_limits<double>::infinity();
  std::vector<double> values;
};

template <class Call>
Timed timed(const std::vector<PosePair>& pairs, int rounds, Call&& call) {
  Timed result;
  result.values.resize(pairs.size());
  for (int round = 0; round < rounds; ++round) {
    const double begun = thread_cpu_seconds();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      result.values[i] = call(pairs[i].from, pairs[i].to);
    }
    const double each = (thread_cpu_seconds() - begun) * 1e9 / static_cast<double>(pairs.size());
    result.nanoseconds = std::min(result.nanoseconds, each);
  }
  return result;
}

#ifdef WEND_WITH_OMPL
std::string beside(const std::string& name, const Timed& ours, const Timed& theirs,
                   std::string& differences) {
  for (std::size_t i = 0; i < ours.values.size(); ++i) {
    if (std::abs(ours.values[i] - theirs.values[i]) <= 1e-6) continue;
    differences += fmt::format("{} of pair {}: {} and {} by OMPL\n", name, i, ours.values[i],
                               theirs.values[i]);
  }
  return fmt::format("{:.0f} ({:.1f})", theirs.nanoseconds, theirs.nanoseconds / ours.nanoseconds);
}
#endif

std::string in_ns(const Timed& timed) { return fmt::format("{:.0f}", timed.nanoseconds); }

constexpr CurveCosts kWeights{.reverse = 2, .turn = 1.2, .gear_change = 0.5};

/// The columns of lengths: ours, and OMPL's.
void add_lengths(const std::vector<PosePair>& pairs, int rounds, std::vector<std::string>& row,
                 std::string& differences) {
  const Timed dubins = timed(pairs, rounds, [](const Pose& from, const Pose& to) {
    return cheapest_dubins(from, to, 1).cost;
  });
  const Timed reeds_shepp = timed(pairs, rounds, [](const Pose& from, const Pose& to) {
    return cheapest_reeds_shepp(from, to, 1).cost;
  });
  std::string dubins_beside;
  std::string reeds_shepp_beside;
  static_cast<void>(differences);  // without OMPL there are none
#ifdef WEND_WITH_OMPL
  const OmplCurves ompl;
  const auto by_dubins = [&](const Pose& from, const Pose& to) { return ompl.dubins(from, to); };
  const auto by_reeds_shepp = [&](const Pose& from, const Pose& to) {
    return ompl.reeds_shepp(from, to);
  };
  dubins_beside = beside("Dubins", dubins, timed(pairs, rounds, by_dubins), differences);
  reeds_shepp_beside =
      beside("Reeds-Shepp", reeds_shepp, timed(pairs, rounds, by_reeds_shepp), differences);
#endif
  row.insert(row.end(), {in_ns(dubins), dubins_beside, in_ns(reeds_shepp), reeds_shepp_beside});
}

/// The columns of weighted costs.
void add_costs(const std::vector<PosePair>& pairs, int rounds, std::vector<std::string>& row) {
  const Timed cheapest = timed(pairs, rounds, [](const Pose& from, const Pose& to) {
    return cheapest_reeds_shepp(from, to, 1, kWeights).cost;
  });
  std::size_t next = 0;
  const Timed bounded = timed(pairs, rounds, [&](const Pose& from, const Pose& to) {
    const double bound = cheapest.values[next++ % pairs.size()];
    return cheapest_reeds_shepp(from, to, 1, kWeights, bound).cost;
  });
  std::array<Curve, 4> words;
  const Timed few = timed(pairs, rounds, [&](const Pose& from, const Pose& to) {
    reeds_shepp_words(from, to, 1, kWeights, kNoBound, words);
    return words.front().cost;
  });
  const Timed simple = timed(pairs, rounds, [&](const Pose& from, const Pose& to) {
    simple_words(from, to, 1, kWeights, kNoBound, words);
    return words.front().cost;
  });
  row.insert(row.end(), {in_ns(cheapest), in_ns(bounded), in_ns(few), in_ns(simple)});
}

}  // namespace

CurveTable curve_table(int count, int rounds) {
  MarkdownTable table({{"square, radii"},
                       {"Dubins, ns"},
                       {"OMPL's, ns (times ours)"},
                       {"Reeds-Shepp, ns"},
                       {"OMPL's, ns (times ours)"},
                       {"weighted, ns"},
                       {"below its cost, ns"},
                       {"4 cheapest words, ns"},
                       {"4 simple words, ns"}});
  CurveTable result;
  for (const double size : {1.0, 3.0, 8.0, 30.0}) {
    const auto pairs = random_pose_pairs(size, count);
    std::vector<std::string> row{format_number(size)};
    add_lengths(pairs, rounds, row, result.differences);
    add_costs(pairs, rounds, row);
    table.add(row);
  }
  result.text = table.text();
  return result;
}

}  // namespace wend::bench
