#pragma once

// The suites of the program wend-suites: what each is called, its flags, and what it measures.

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>

namespace wend::bench {

/// Measures and prints; returns the exit code.
using Measure = std::function<int()>;

/// One suite. `add` gives a subcommand its flags, and returns what to do when they have been read.
struct Suite {
  const char* name;
  const char* what;
  Measure (*add)(CLI::App& app);
};

/// All of them; the first is the default.
std::span<const Suite> suites();

/// Bad usage or input: ends the program with exit code 2.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What was measured is wrong: ends the program with exit code 1.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value of an Expected; throws Refused with its error.
template <class Result>
auto value_or_refuse(Result result) {
  if (!result) throw Refused(result.error().message);
  return *std::move(result);
}

/// --rounds: the fastest counts.
inline void add_rounds(CLI::App& app, int& rounds) {
  app.add_option("--rounds", rounds, "timed runs of everything; the fastest counts")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
}

}  // namespace wend::bench
