#include "cli/watching/watching.hpp"

#include <fmt/format.h>

#include <string_view>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"

namespace wend::cli {
namespace {

constexpr const char* kGroup = "Watching the search";

bool ends_in(std::string_view text, std::string_view end) {
  return text.size() > end.size() && text.ends_with(end);
}

bool is_yaml(const std::string& file) {
  return ends_in(file, ".trace.yaml") || ends_in(file, ".trace.yml");
}

}  // namespace

void WatchArguments::add_to(Parser& app) {
  app.add_flag("--verbose", verbose,
               wrapped("Print every search event to standard error, one per line"))
      .group(kGroup);
  app.add_flag("--open-list", open_list,
               wrapped("With --verbose: print the next ten entries of the open list as a table "
                       "before each expansion"))
      .group(kGroup);
  app.add_flag("--step", step,
               wrapped("Show the search and its open list after each expansion and wait for a key; "
                       "keys step forwards and backwards"));
  app.add_flag("--animate", animate, wrapped("Play the search on the terminal"));
  add_number(app, "--speed", speed, kFilmSpeeds,
             "Expansions per second of --animate and of a .gif (default: a few seconds in total)")
      .group(kGroup);
  app.add_option("--trace", trace,
                 wrapped("Write the search as a trace for Posthoc; the name must end in "
                         ".trace.yaml or .trace.json"))
      .type_name(kFileType)
      .group(kGroup);
  add_count(app, "--trace-limit", trace_limit,
            "Limit on the number of events in a trace (default 200000, about 20 MB)")
      .group(kGroup);
}

void WatchArguments::check(const Screen& screen) const {
  if (animate && !screen.is_terminal) {
    throw InputError("--animate needs a terminal; -o search.gif writes the animation to a file");
  }
  if (open_list && !verbose) {
    throw InputError("--open-list needs --verbose; --step shows the open list without it");
  }
  if (animate && step) throw InputError("--animate cannot be combined with --step");
  if (trace.empty()) return;
  if (!is_yaml(trace) && !ends_in(trace, ".trace.json")) {
    throw InputError(
        fmt::format("--trace {}: the name must end in .trace.yaml or .trace.json", trace));
  }
  check_folder(trace, "--trace " + trace);
}

TraceForm WatchArguments::trace_form() const {
  return is_yaml(trace) ? TraceForm::yaml : TraceForm::json;
}

}  // namespace wend::cli
