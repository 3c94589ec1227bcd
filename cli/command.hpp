#pragma once

// A subcommand: its arguments, and what it does with them. One source file each.

#include <CLI/App.hpp>
#include <functional>

namespace wend::cli {

struct Command {
  CLI::App* app;             // owned by the app that it was added to
  std::function<int()> run;  // after parsing; returns the exit code, throws InputError
};

Command add_plan(CLI::App& app);
Command add_field(CLI::App& app);
Command add_bench(CLI::App& app);
Command add_index(CLI::App& app);
Command add_planners(CLI::App& app);
Command add_info(CLI::App& app);
Command add_generate(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_explain(CLI::App& app);
Command add_view(CLI::App& app);
Command add_convert(CLI::App& app);
Command add_check(CLI::App& app);
Command add_smooth(CLI::App& app);
Command add_follow(CLI::App& app);

/// Completes the subcommands that have been added to `app` before.
Command add_completion(CLI::App& app);

}  // namespace wend::cli
