// wend-suites: everything that is measured about wend, a suite for each subject. All times are CPU time.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <vector>

#include "bench/suites/suite.hpp"

namespace wend::bench {

#define WEND_SUITE(name, what) Measure add_##name(CLI::App& app);
#include "bench/suites/suites.def"
#undef WEND_SUITE

std::span<const Suite> suites() {
  static constexpr std::array kSuites{
#define WEND_SUITE(name, what) Suite{#name, what, add_##name},
#include "bench/suites/suites.def"
#undef WEND_SUITE
  };
  return kSuites;
}

namespace {

int run(int argc, char** argv) {
  CLI::App app("Measures wend, in CPU time. `wend-suites SUITE --help` tells what a suite takes.");
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Measure>> measures;
  for (const Suite& suite : suites()) {
    CLI::App* const command = app.add_subcommand(suite.name, suite.what);
    measures.emplace_back(command, suite.add(*command));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const auto& [command, measure] : measures) {
    if (command->parsed()) return measure();
  }
  return 2;
}

}  // namespace
}  // namespace wend::bench

int main(int argc, char** argv) {
  try {
    return wend::bench::run(argc, argv);
  } catch (const wend::bench::Refused& refused) {
    fmt::print(stderr, "wend-suites: {}\n", refused.what());
    return 2;
  } catch (const wend::bench::Wrong& wrong) {
    fmt::print(stderr, "wend-suites: {}\n", wrong.what());
    return 1;
  }
}
