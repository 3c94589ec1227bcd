#pragma once

// A subcommand: its arguments, and what it does with them. One source file each.

#include <functional>

#include "cli/arguments/parser.hpp"

namespace wend::cli {

struct Command {
  Parser parser;
  std::function<int()> run;  // after parsing; returns the exit code, throws InputError
};

Command add_plan(Parser& app);
Command add_field(Parser& app);
Command add_index(Parser& app);
Command add_planners(Parser& app);

Command add_info(Parser& app);
Command add_generate(Parser& app);

/// `wend generate scenario`, a subcommand of generate.
Command add_generate_scenario(Parser& generate);

Command add_compare(Parser& app);
Command add_explore(Parser& app);
Command add_explain(Parser& app);
Command add_view(Parser& app);
Command add_convert(Parser& app);
Command add_check(Parser& app);
Command add_smooth(Parser& app);
Command add_follow(Parser& app);

}  // namespace wend::cli
