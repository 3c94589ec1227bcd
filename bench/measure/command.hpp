#pragma once

// The command line of a benchmark program.

#include <CLI/CLI.hpp>

namespace wend::bench {

/// Parses the arguments and returns what work() returns; after --help 0, after wrong arguments 2.
template <class Work>
int parse_and_run(CLI::App& app, int argc, char** argv, Work&& work) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return work();
}

}  // namespace wend::bench
