#pragma once

// How a person follows a search: told line by line, step by step, played, or kept as a trace.

#include <cstdint>
#include <optional>
#include <string>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/parser.hpp"
#include "cli/output/terminal.hpp"
#include "wend/report/posthoc_trace.hpp"

namespace wend::cli {

inline constexpr NumberRange kFilmSpeeds{0.1, 1e9, "expansions per second"};

struct WatchArguments {
  bool verbose = false;
  bool open_list = false;  // with verbose
  bool step = false;
  bool animate = false;
  std::optional<double> speed;          // expansions a second
  std::string trace;                    // a file; empty: none
  std::uint64_t trace_limit = 200'000;  // events, some 20 MB

  void add_to(Parser& app);

  /// Throws InputError where the flags cannot be honoured.
  void check(const Screen& screen) const;

  /// The form that the trace's file name asks for.
  TraceForm trace_form() const;
};

}  // namespace wend::cli
