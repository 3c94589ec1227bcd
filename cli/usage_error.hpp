#pragma once

// What to tell a user whose command line could not be parsed.

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace wend::cli {

/// One line on what is wrong, with a suggestion for a misspelt flag or subcommand, and one on where
/// the help is.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace wend::cli
