#pragma once

// HelpFormatter: what --help shows of an argument: "-o, --output FILE", "--in-place, --no-in-place",
// "--smooth[=ALPHA,BETA]" for an optional value. Spellings with underscores are accepted, but
// not shown.

#include <CLI/Formatter.hpp>
#include <string>
#include <vector>

namespace wend::cli {

/// The spellings of an option that help shows: "-o", "--output".
std::vector<std::string> shown_names(const CLI::Option& option);

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace wend::cli
