// Every line of code that a header or README.md shows stands in a test that compiles and runs it.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "tests/testing/build_paths.hpp"
namespace {

namespace fs = std::filesystem;

const fs::path kSource = wend::test::source_folder();

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// A line without what surrounds its code: blanks and, in headers, the comment's slashes.
std::string_view code_of(std::string_view line) {
  const std::size_t first = line.find_first_not_of("/ \t");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
}

/// The lines of code of the tests of snippets.
std::set<std::string, std::less<>> compiled_lines() {
  std::set<std::string, std::less<>> lines;
  for (const auto* const name :
       {"snippets_test.cpp", "search_snippets_test.cpp", "planning_snippets_test.cpp",
        "control_snippets_test.cpp", "session_snippets_test.cpp", "plugin_snippets_test.cpp",
        "c_snippets_test.cpp", "cost_snippets_test.cpp"}) {
    std::istringstream text(text_of(kSource / "tests" / "snippets" / name));
    for (std::string line; std::getline(text, line);) lines.emplace(code_of(line));
  }
  return lines;
}

bool is_statement(std::string_view code) {
  return !code.empty() && (code.back() == ';' || code.back() == '{') &&
         code.find("...") == std::string_view::npos;
}

/// Is it a line of a snippet? Snippets are indented in their comments.
bool is_shown(std::string_view line) { return line.find("//   ") < line.find_first_not_of(" /"); }

TEST(SnippetLines, OfHeadersAreCompiled) {
  const auto compiled = compiled_lines();
  int headers = 0;
  for (const auto* const folder : {"wend", "bench"}) {
    for (const auto& file : fs::recursive_directory_iterator(kSource / folder)) {
      const fs::path extension = file.path().extension();
      if (extension != ".hpp" && extension != ".h") continue;
      std::istringstream text(text_of(file.path()));
      bool shows = false;
      for (std::string line; std::getline(text, line);) {
        if (!is_shown(line) || !is_statement(code_of(line))) continue;
        shows = true;
        EXPECT_TRUE(compiled.contains(code_of(line)))
            << file.path() << " shows a line that no test of snippets compiles:\n  "
            << code_of(line);
      }
      headers += shows ? 1 : 0;
    }
  }
  EXPECT_GT(headers, 60) << "few headers show a snippet";
}

TEST(SnippetLines, OfReadmeAreTheExample) {
  const std::string readme = text_of(kSource / "README.md");
  const std::string example = text_of(kSource / "examples" / "plan_path.cpp");
  ASSERT_FALSE(example.empty());
  EXPECT_NE(readme.find("```cpp\n" + example + "```\n"), std::string::npos)
      << "README.md does not show examples/plan_path.cpp as it stands";
}

}  // namespace
