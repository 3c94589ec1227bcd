// The program wend-planner-page, and the page that it wrote for docs/.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "tests/command_line/run_program.hpp"
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

  std::size_t column(const std::string& name) const {
    const auto place = std::find(rows.front().begin(), rows.front().end(), name);
    EXPECT_NE(place, rows.front().end()) << heading << ": no column " << name;
    return static_cast<std::size_t>(place - rows.front().begin());
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

/// The tables of what planners made of queries.
std::vector<Table> measured_tables(const std::string& page) {
  std::vector<Table> tables = tables_in(page);
  std::erase_if(tables, [](const Table& table) {
    return table.rows.front().size() < 2 || table.rows.front()[1] != "solved";
  });
  return tables;
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

/// What does not depend on how fast anything was.
std::string without_times(const Table& table) {
  std::string text = table.heading;
  const Row& titles = table.rows.front();
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!titles[i].starts_with("time")) text += " | " + row[i];
    }
    text += '\n';
  }
  return text;
}

std::filesystem::path committed() { return std::filesystem::path(WEND_SOURCE_DIR) / "docs"; }

/// A folder that the program has written to.
class PlannerPage : public testing::Test {
 protected:
  PlannerPage()
      : outcome_(run_program({WEND_PLANNER_PAGE_PATH, "--quick", folder_ / "docs"})),
        page_(bytes_of(folder_ / "docs/planners.md")) {}

  TemporaryFolder folder_;
  Outcome outcome_;
  std::string page_;
};

TEST_F(PlannerPage, IsWritten) {
  EXPECT_EQ(outcome_.code, 0) << outcome_.err;
  EXPECT_THAT(outcome_.out, IsEmpty());
  EXPECT_THAT(page_,
              AllOf(HasSubstr("# Planners\n"), HasSubstr("./run docs"),
                    HasSubstr("## Which wins where, and why"), Not(HasSubstr(WEND_SOURCE_DIR))));
}

TEST_F(PlannerPage, HasASectionForEveryPlanner) {
  const std::string registry = registry_part(page_) + "\n### ";
  for (const PlannerInfo& planner : planners()) {
    const std::string section = between(registry, "\n### " + planner.name + "\n", "\n### ");
    for (const std::string& text : {planner.summary, planner.idea, planner.guarantee_text,
                                    planner.time, planner.memory, planner.when, planner.citation}) {
      EXPECT_THAT(section, HasSubstr(text));
    }
    for (const OptionInfo& option : planner.options) {
      EXPECT_THAT(section, HasSubstr("| `" + option.name + "`"));
      EXPECT_THAT(section, HasSubstr("| " + option.help + " |"));
    }
    EXPECT_THAT(section, HasSubstr("](images/planners/" + planner.name + ".png)"));
  }
}

TEST_F(PlannerPage, ShowsPicturesThatAreThere) {
  std::size_t pictures = 0;
  for (std::size_t at = page_.find("]("); at != std::string::npos; at = page_.find("](", at + 1)) {
    const std::string target = page_.substr(at + 2, page_.find(')', at) - at - 2);
    if (target.starts_with("#")) continue;
    ++pictures;
    EXPECT_TRUE(bytes_of(folder_ / ("docs/" + target)).starts_with("\x89PNG\r\n\x1a\n")) << target;
    EXPECT_TRUE(std::filesystem::exists(committed() / target)) << target;
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
  const std::vector<Table> tables = measured_tables(page_);
  ASSERT_GE(tables.size(), 10U);
  for (const Table& table : tables) {
    for (const PlannerInfo& planner : planners()) {
      if (planner.motion != Motion::cells || planner.index_support) continue;
      if (planner.guarantee == Guarantee::none && table.heading != "Small rooms") continue;
      const bool is_for_all =
          table.heading != "Rooms, 4 neighbours" && table.heading != "Rough ground";
      if (planner.jumps && !is_for_all) continue;
      const bool there = std::any_of(table.rows.begin(), table.rows.end(), [&](const Row& row) {
        return row[0] == planner.name || row[0] == planner.name + ":connectivity=4";
      });
      EXPECT_TRUE(there) << table.heading << ": " << planner.name;
    }
  }
  EXPECT_THAT(page_,
              AllOf(HasSubstr("| `astar:weight=2` |"), HasSubstr("| `astar:heuristic=euclidean` |"),
                    HasSubstr("| `bfs:connectivity=4` |"), HasSubstr("### Keeping away")));
}

TEST_F(PlannerPage, HasNumbersInItsTables) {
  for (const Table& table : measured_tables(page_)) {
    for (std::size_t y = 1; y < table.rows.size(); ++y) {
      const Row& row = table.rows[y];
      ASSERT_EQ(row.size(), table.rows.front().size()) << table.heading;
      for (std::size_t x = 2; x < row.size(); ++x) {
        const auto number = parse_number(row[x]);
        EXPECT_TRUE(number && std::isfinite(*number) && *number >= 0) << table.heading << row[x];
      }
      const std::string queries = row[1].substr(row[1].find("of"));
      const bool has_path = table.heading != "No path";
      EXPECT_EQ(row[1], (has_path ? queries.substr(3) : "0") + " " + queries) << table.heading;
      if (!has_path) continue;
      const double cost = *parse_number(row[table.column("cost / cheapest")]);
      EXPECT_GE(cost, 1) << table.heading;
      EXPECT_GE(*parse_number(row[table.column("worst")]), cost) << table.heading;
      if (row[0].starts_with("dijkstra")) {
        EXPECT_EQ(cost, 1) << table.heading;
      }
    }
  }
}

TEST_F(PlannerPage, SaysTheSameAgainButForTimes) {
  const Outcome again = run_program({WEND_PLANNER_PAGE_PATH, "--quick", folder_ / "again"});
  ASSERT_EQ(again.code, 0);
  const std::string other = bytes_of(folder_ / "again/planners.md");
  EXPECT_EQ(registry_part(other), registry_part(page_));
  const std::vector<Table> tables = measured_tables(page_);
  const std::vector<Table> others = measured_tables(other);
  ASSERT_EQ(tables.size(), others.size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    EXPECT_EQ(without_times(tables[i]), without_times(others[i]));
  }
}

TEST_F(PlannerPage, InDocsIsUpToDate) {
  EXPECT_EQ(registry_part(bytes_of(committed() / "planners.md")), registry_part(page_))
      << "run ./run docs";
}

TEST(PlannerPageProgram, NamesADataFileThatIsNotThere) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({WEND_PLANNER_PAGE_PATH, "--data", folder / "nowhere", folder / "docs"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/nine/"));
  EXPECT_FALSE(std::filesystem::exists(folder / "docs"));
}

TEST(PlannerPageProgram, NamesAFolderThatItCannotWriteTo) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({WEND_PLANNER_PAGE_PATH, "--quick", folder.write("file", "") + "/docs"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("file/docs/images"));
}

}  // namespace
}  // namespace wend::test
