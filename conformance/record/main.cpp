// wend-trials: writes trials of all planners, a line each. python/tests/test_conformance.py reads them.

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <optional>

#include "conformance/record/trial_json.hpp"
#include "wend/base/parse.hpp"
#include "wend/planner/planners.hpp"

int main(int argc, char** argv) {
  const auto seeds = argc == 2 ? wend::parse_integer<std::uint64_t>(argv[1]) : std::nullopt;
  if (!seeds || *seeds == 0) {
    fmt::print(stderr,
               "usage: wend-trials COUNT    trials for each planner, from the seeds 1 to COUNT\n");
    return 2;
  }
  for (const wend::PlannerInfo& planner : wend::planners()) {
    for (std::uint64_t seed = 1; seed <= *seeds; ++seed) {
      fmt::print("{}\n", wend::test::trial_json(planner, seed));
    }
  }
  return 0;
}
