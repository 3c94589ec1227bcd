#pragma once

// HelpFormatter: what --help shows of an argument: "-o, --output FILE", "--in-place, --no-in-place",
// "--smooth[=ALPHA,BETA]" of one whose value is optional. Spellings with underscores are taken, but
// not shown.

#include <CLI/Formatter.hpp>
#include <string>

namespace wend::cli {

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace wend::cli
