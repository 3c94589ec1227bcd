#pragma once

// The message for a command line that could not be parsed.

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is CLI11's
class App;
class ParseError;
}  // namespace CLI

namespace wend::cli {

/// One line on what is wrong, with a suggestion for a misspelt flag or subcommand, and one on where
/// the help is.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The same where a flag was taken for the value of another, as in `--start --goal 1,2`; empty if
/// none was. The parser reports no error, because values may be anything.
std::string swallowed_flag(const CLI::App& app);

}  // namespace wend::cli
