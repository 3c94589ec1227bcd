// wend-counted: a planner answers a fixed set of queries, for scripts/instructions, which has valgrind
// count the instructions that this takes.

#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/comparison/random_queries.hpp"
#include "wend/generate/generators.hpp"
#include "wend/planner/planners.hpp"

namespace wend::bench {
namespace {

struct CountedMap {
  const char* generator;
  OptionValues options;
};

constexpr int kSize = 192;
constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kQueries = 25;  // a map

std::vector<CountedMap> counted_maps() {
  return {{"office", {}}, {"maze", {}}, {"random", {{"density", "0.35"}}}, {"rooms", {}}};
}

/// The planners to count: all that find a cheapest path of cells with default options.
std::vector<std::string> counted_planners() {
  std::vector<std::string> names;
  for (const PlannerInfo& info : planners()) {
    const bool optimal =
        info.guarantee == Guarantee::optimal || info.guarantee == Guarantee::bounded;
    if (!info.capabilities.headings && optimal) names.push_back(info.name);
  }
  return names;
}

std::string toolchain() {
#if defined(__clang__)
  const std::string compiler = fmt::format("clang {}", __clang_version__);
#else
  const std::string compiler = fmt::format("g++ {}", __VERSION__);
#endif
  return fmt::format("{}, glibc {}", compiler, gnu_get_libc_version());
}

}  // namespace

/// What valgrind counts, found by its name. Returns the sum of the costs of all paths.
[[gnu::noinline]] double counted_answers(Planner& planner, const std::vector<Query>& queries,
                                         Plan& plan) {
  double cost = 0;
  for (const Query& query : queries) {
    if (planner.plan(query, plan) == Status::found) cost += plan.cost;
  }
  return cost;
}

namespace {

/// Neither fresh memory nor what a planner learns at first is what is counted.
void warm_up(const std::string& name, Planner& planner, const std::vector<Query>& queries,
             Plan& plan) {
  planner.plan(queries.front(), plan);
  if (!planners().find(name)->capabilities.learns) return;
  constexpr int kRounds = 50;
  for (int round = 0; round < kRounds; ++round) {
    for (const Query& query : queries) planner.plan(query, plan);
  }
}

int run(const std::string& name) {
  double cost = 0;
  for (const CountedMap& counted : counted_maps()) {
    const auto map = make_map(counted.generator, kSize, kSize, kSeed, counted.options);
    if (!map) return std::fputs(map.error().message.c_str(), stderr), 2;
    const FreeSpace space = *make_free_space(*map);
    const auto planner = make_planner(name, space);
    if (!planner) return std::fputs(planner.error().message.c_str(), stderr), 2;
    std::vector<Query> queries;
    for (const CellPair& cells : random_pairs(space, kQueries, kSeed)) {
      queries.push_back(Query::between(cells.start, cells.goal));
    }
    Plan plan;
    warm_up(name, **planner, queries, plan);
    cost += counted_answers(**planner, queries, plan);
  }
  fmt::print("{:.6f}\n", cost);
  return 0;
}

}  // namespace
}  // namespace wend::bench

int main(int argc, char** argv) {
  const std::string_view what = argc == 2 ? argv[1] : "";
  if (what == "--planners") {
    for (const std::string& name : wend::bench::counted_planners()) fmt::print("{}\n", name);
    return 0;
  }
  if (what == "--toolchain") return fmt::print("{}\n", wend::bench::toolchain()), 0;
  if (!what.empty()) return wend::bench::run(std::string(what));
  std::fputs("usage: wend-counted PLANNER | --planners | --toolchain\n", stderr);
  return 2;
}
