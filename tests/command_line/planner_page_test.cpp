// The program wend-planner-page, and the page that it wrote for docs/.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "tests/command_line/run_program.hpp"
#include "tests/testing/build_paths.hpp"
#include "wend/base/parse.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Row = std::vector<std::string>;

/// A table, and the heading above it.
struct Table {
  std::string heading;
  std::vector<Row> rows;  // the columns' names first

  bool has_column(const std::string& name) const {
    return std::find(rows.front().begin(), rows.front().end(), name) != rows.front().end();
  }
};

/// The fields of a line, without marks of bold and code.
Row fields_of(const std::string& line) {
  Row fields;
  std::string field;
  for (std::size_t i = 2; i < line.size(); ++i) {
    if (line[i] == '|' && line[i - 1] != '\\') {
      fields.push_back(field.substr(0, field.find_last_not_of(' ') + 1));
      field.clear();
      ++i;
    } else if (line[i] != '*' && line[i] != '`') {
      field += line[i];
    }
  }
  return fields;
}

std::vector<Table> tables_in(const std::string& page) {
  std::vector<Table> tables;
  std::istringstream lines(page);
  std::string heading;
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) heading = line.substr(line.find(' ') + 1);
    const bool row = line.starts_with("| ");
    if (row && !in_table) tables.push_back({heading, {}});
    if (row) tables.back().rows.push_back(fields_of(line));
    in_table = row || line.starts_with("|-");
  }
  return tables;
}

/// The first table below that heading.
Table table_below(const std::string& heading, const std::string& page) {
  for (const Table& table : tables_in(page)) {
    if (table.heading == heading) return table;
  }
  ADD_FAILURE() << "no table below " << heading;
  return {heading, {{}}};
}

/// The tables with a row a map and a column a planner.
std::vector<Table> planner_tables(const std::string& page) {
  return {table_below("Time", page), table_below("Cells expanded", page),
          table_below("Path cost", page)};
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  const std::size_t to = text.find(end, from == std::string::npos ? 0 : from + begin.size());
  EXPECT_TRUE(from != std::string::npos && to != std::string::npos) << begin << end;
  return from == std::string::npos ? std::string() : text.substr(from, to - from);
}

std::string registry_part(const std::string& page) {
  return between(page, "<!-- from the registry -->", "<!-- measured -->");
}

/// What does not depend on how fast anything was: all tables but those of times, without the times in them.
std::vector<Row> rows_without_times(const std::string& page) {
  std::vector<Row> rows;
  for (const Table& table : tables_in(page)) {
    if (table.heading == "Time") continue;
    for (Row row : table.rows) {
      const bool has_time_column = table.rows.front().back().starts_with("time");
      const bool is_time_row = row.size() > 1 && row[1].starts_with("time");
      if (has_time_column) row.pop_back();
      if (!is_time_row) rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// The numbers of a field such as "310 µs", "1.05 (1.20)" or "200 of 200".
std::vector<double> numbers_of(const std::string& field) {
  std::vector<double> numbers;
  std::string digits;
  for (const char letter : field + " ") {
    if (std::isdigit(static_cast<unsigned char>(letter)) != 0 || letter == '.' ||
        (!digits.empty() && (letter == 'e' || letter == '-'))) {
      digits += letter;
    } else if (!digits.empty()) {
      const auto number = parse_number(digits);
      EXPECT_TRUE(number) << field;
      numbers.push_back(number ? *number : std::nan(""));
      digits.clear();
    }
  }
  return numbers;
}

std::filesystem::path committed() { return source_folder() / "docs"; }

/// A folder that the program has written to.
class PlannerPage : public testing::Test {
 protected:
  PlannerPage()
      : outcome_(run_program({planner_page_program(), "--quick", folder_ / "docs"})),
        page_(bytes_of(folder_ / "docs/planners.md")) {}

  TemporaryFolder folder_;
  Outcome outcome_;
  std::string page_;
};

TEST_F(PlannerPage, IsWritten) {
  EXPECT_EQ(outcome_.code, 0) << outcome_.err;
  EXPECT_THAT(outcome_.out, IsEmpty());
  EXPECT_THAT(page_, AllOf(HasSubstr("# Planners\n"), HasSubstr("./run docs"),
                           HasSubstr("## Measurements"), Not(HasSubstr(source_folder().string()))));
}

TEST_F(PlannerPage, HasASectionForEveryPlanner) {
  const std::string registry = registry_part(page_) + "\n### ";
  const std::string overview = between(registry, "\n## Overview\n", "\n## Planners\n");
  for (const PlannerInfo& planner : planners()) {
    const std::string section = between(registry, "\n### " + planner.name + "\n", "\n### ");
    for (const std::string& text :
         {planner.summary, planner.idea, planner.guarantee_text, planner.when, planner.citation}) {
      EXPECT_THAT(section, HasSubstr(text));
    }
    EXPECT_THAT(section, HasSubstr("](images/planners/" + planner.name + ".png)"));
    EXPECT_THAT(overview, HasSubstr("| [" + planner.name + "](#" + planner.name + ") |"));
    EXPECT_THAT(overview, HasSubstr("| " + planner.time + " | " + planner.memory + " |"));
  }
}

TEST_F(PlannerPage, ListsTheOptionsOfEveryPlanner) {
  const Table table = table_below("Options", page_);
  for (const PlannerInfo& planner : planners()) {
    for (const OptionInfo& option : planner.options) {
      const std::string help = fields_of("| " + option.help + " |").front();
      const auto rows = std::count_if(table.rows.begin(), table.rows.end(), [&](const Row& row) {
        const std::string listed = ", " + row.at(1) + ",";
        return (row[0] + " ").starts_with(option.name + " ") &&
               listed.find(", " + planner.name + ",") != std::string::npos &&
               row.at(2) == option.default_value && row.at(4) == help;
      });
      EXPECT_EQ(rows, 1) << planner.name << " " << option.name;
    }
  }
}

TEST_F(PlannerPage, ShowsPicturesThatAreThere) {
  std::size_t pictures = 0;
  for (std::size_t at = page_.find("]("); at != std::string::npos; at = page_.find("](", at + 1)) {
    const std::string target = page_.substr(at + 2, page_.find(')', at) - at - 2);
    if (target.starts_with("#")) continue;
    EXPECT_TRUE(std::filesystem::exists(committed() / target)) << target;
    if (!target.ends_with(".png")) continue;
    ++pictures;
    EXPECT_TRUE(bytes_of(folder_ / ("docs/" + target)).starts_with("\x89PNG\r\n\x1a\n")) << target;
  }
  EXPECT_EQ(pictures, planners().size());
}

TEST_F(PlannerPage, LinksToSectionsThatAreThere) {
  for (std::size_t at = page_.find("](#"); at != std::string::npos;
       at = page_.find("](#", at + 1)) {
    const std::string anchor = page_.substr(at + 3, page_.find(')', at) - at - 3);
    std::istringstream lines(page_);
    std::vector<std::string> anchors;
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("#")) continue;
      line.erase(0, line.find(' ') + 1);
      std::erase(line, ',');
      for (char& letter : line) {
        letter = letter == ' ' ? '-' : static_cast<char>(std::tolower(letter));
      }
      anchors.push_back(line);
    }
    EXPECT_THAT(anchors, Contains(anchor));
  }
}

TEST_F(PlannerPage, MeasuresEveryPlanner) {
  const std::string committed_page = bytes_of(committed() / "planners.md");
  for (const std::string& page : {page_, committed_page}) {
    for (const std::string heading : {"Time", "Cells expanded"}) {
      const Table table = table_below(heading, page);
      EXPECT_EQ(table.rows.front().at(1), "astar");
      for (const PlannerInfo& planner : planners()) {
        const bool keeps_answers =
            planner.capabilities.resumes && planner.preprocessing == Preprocessing::none;
        const bool measured = !planner.capabilities.headings && !planner.capabilities.any_angle &&
                              !planner.index_support && planner.guarantee != Guarantee::none &&
                              !keeps_answers;
        EXPECT_EQ(table.has_column(planner.name), measured) << heading << planner.name;
      }
      EXPECT_TRUE(table.has_column("astar:weight=2"));
      EXPECT_TRUE(table.has_column("astar:heuristic=euclidean"));
      EXPECT_GE(table.rows.size(), 10U);
    }
    EXPECT_EQ(table_below("Clearance cost", page).rows.size(), 5U);
    EXPECT_EQ(table_below("Driving", page).rows.size(), 10U);
  }
}

TEST_F(PlannerPage, MeasuresEveryMap) {
  const Table maps = table_below("Measurements", page_);
  ASSERT_GE(maps.rows.size(), 10U);
  for (std::size_t y = 1; y < maps.rows.size(); ++y) {
    const std::vector<double> solved = numbers_of(maps.rows[y].at(4));
    EXPECT_TRUE(solved.size() == 2 && solved[0] == solved[1] && solved[0] > 0) << maps.rows[y][0];
    for (const Table& table : planner_tables(page_)) {
      ASSERT_EQ(table.rows.size(), maps.rows.size()) << table.heading;
      EXPECT_EQ(table.rows[y][0], maps.rows[y][0]) << table.heading;
    }
  }
}

TEST_F(PlannerPage, HasNumbersInItsTables) {
  for (const Table& table : planner_tables(page_)) {
    for (std::size_t y = 1; y < table.rows.size(); ++y) {
      const Row& row = table.rows[y];
      ASSERT_EQ(row.size(), table.rows.front().size()) << table.heading;
      for (std::size_t x = 1; x < row.size(); ++x) {
        // jps refuses 4 neighbours and terrain.
        const bool refused = table.rows.front()[x] == "jps" &&
                             (row[0] == "Rooms, 4 neighbours" || row[0] == "Rough ground");
        EXPECT_EQ(row[x] == "–", refused) << table.heading << ": " << row[0];
        if (refused) continue;
        const std::vector<double> numbers = numbers_of(row[x]);
        ASSERT_EQ(numbers.size(), table.heading == "Path cost" ? 2U : 1U) << row[x];
        for (const double number : numbers) EXPECT_TRUE(std::isfinite(number)) << row[x];
      }
    }
  }
}

TEST_F(PlannerPage, ListsPathCostsOfPlannersThatAreNotOptimal) {
  const Table costs = table_below("Path cost", page_);
  for (const char* const optimal : {"astar", "dijkstra", "jps", "astar:heuristic=euclidean"}) {
    EXPECT_FALSE(costs.has_column(optimal)) << optimal;
  }
  for (const char* const other : {"greedy", "bfs", "dfs", "astar:weight=2"}) {
    EXPECT_TRUE(costs.has_column(other)) << other;
  }
  for (std::size_t y = 1; y < costs.rows.size(); ++y) {
    for (std::size_t x = 1; x < costs.rows[y].size(); ++x) {
      const std::vector<double> numbers = numbers_of(costs.rows[y][x]);
      ASSERT_EQ(numbers.size(), 2U) << costs.rows[y][x];
      EXPECT_GE(numbers[0], 1) << costs.rows[y][0];
      EXPECT_GE(numbers[1], numbers[0]) << costs.rows[y][0];
    }
  }
}

TEST_F(PlannerPage, SaysTheSameAgainButForTimes) {
  const Outcome again = run_program({planner_page_program(), "--quick", folder_ / "again"});
  ASSERT_EQ(again.code, 0);
  const std::string other = bytes_of(folder_ / "again/planners.md");
  EXPECT_EQ(registry_part(other), registry_part(page_));
  EXPECT_EQ(rows_without_times(other), rows_without_times(page_));
}

TEST_F(PlannerPage, RefreshesTheRegistryPartAlone) {
  std::string old = page_;
  old.replace(old.find("## Overview"), 20, "an old text");
  const std::string file = folder_.write("docs/planners.md", old);
  const Outcome outcome =
      run_program({planner_page_program(), "--registry-only", folder_ / "docs"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(bytes_of(file), page_);
}

TEST_F(PlannerPage, InDocsIsUpToDate) {
  EXPECT_EQ(registry_part(bytes_of(committed() / "planners.md")), registry_part(page_))
      << "run ./run docs --registry-only";
}

TEST(PlannerPageProgram, NamesADataFileThatIsNotThere) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({planner_page_program(), "--data", folder / "nowhere", folder / "docs"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/nine/"));
  EXPECT_FALSE(std::filesystem::exists(folder / "docs"));
}

TEST(PlannerPageProgram, NamesAFolderThatItCannotWriteTo) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({planner_page_program(), "--quick", folder.write("file", "") + "/docs"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("file/docs/images"));
}

TEST(PlannerPageProgram, NeedsAPageToRefresh) {
  const TemporaryFolder folder;
  const std::string name = folder.write("planners.md", "# Planners\n");
  const Outcome outcome = run_program({planner_page_program(), "--registry-only", folder / ""});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("planners.md: the comments around the registry part"));
  EXPECT_EQ(bytes_of(name), "# Planners\n");
}

}  // namespace
}  // namespace wend::test
