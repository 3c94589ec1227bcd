// docs/motion.md does what it says: its commands work in their order, and what it quotes below a
// command stands in what that command prints.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {
namespace {

/// Lines between ``` and ```.
struct Block {
  std::string language;
  std::vector<std::string> lines;
};

std::vector<Block> blocks_of(const std::filesystem::path& page) {
  std::vector<Block> blocks;
  std::ifstream text(page);
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), {}});
    } else if (inside) {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

/// In a folder, as somebody types it; both streams together.
std::string printed_by(const std::string& line, const TemporaryFolder& folder) {
  const std::string typed = line.starts_with("wend ") ? "\"$WEND\"" + line.substr(4) : line;
  const Outcome outcome = shell("cd " + (folder / "").string() + " && " + typed);
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << line << "\n" << outcome.err;
  return outcome.out + outcome.err;
}

/// With # for every number: how fast something is, and the last digits, are not the same everywhere.
std::string without_numbers(const std::string& text) {
  return std::regex_replace(text, std::regex("[0-9]+([.][0-9]+)?"), "#");
}

TEST(MotionPage, QuotesWhatItsCommandsPrint) {
  const TemporaryFolder folder;
  std::string printed;
  int commands = 0;
  int quotes = 0;
  for (const Block& block : blocks_of(source_folder() / "docs" / "motion.md")) {
    for (const std::string& line : block.lines) {
      if (block.language == "sh") {
        printed = printed_by(line, folder);
        ++commands;
      } else if (block.language.empty()) {
        EXPECT_NE(without_numbers(printed).find(without_numbers(line) + "\n"), std::string::npos)
            << line << "\nis not in\n"
            << printed;
        ++quotes;
      }
    }
  }
  EXPECT_GT(commands, 5);
  EXPECT_GT(quotes, 3);
}

}  // namespace
}  // namespace wend::test
