#include "wend/report/scenario_verdict.hpp"

#include <fmt/format.h>

#include "wend/base/parse.hpp"
#include "wend/space/grid_path.hpp"

namespace wend {

std::string wrong_answer(const ScenarioQuery& query, Status status, const Plan& plan) {
  const bool solved = status == Status::found;
  const std::string expected = format_number(query.length);
  if (query.says_no_path()) {
    if (!solved) return {};
    return fmt::format("found a path of length {:.8g}, the file says that there is none",
                       plan.path.length());
  }
  if (!solved) {
    return fmt::format("found none ({}), the file has one of length {}", describe(status),
                       expected);
  }
  const double length = plan.path.length();
  if (length_matches(query, length)) return {};
  return fmt::format("found a path of length {:.8f}, the file says {}", length, expected);
}

std::string wrong_path(const FreeSpace& space, const ScenarioQuery& query, const Path& path) {
  const auto cells = path.cells();
  if (cells.empty() || cells.front() != query.start || cells.back() != query.goal) {
    return "the path does not join start and goal";
  }
  const auto cost = check_grid_path(space, {Connectivity::eight, CornerRule::none}, cells);
  return cost ? std::string() : "not a valid path: " + cost.error().what;
}

}  // namespace wend
