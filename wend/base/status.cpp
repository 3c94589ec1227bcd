#include "wend/base/status.hpp"

#include <array>

namespace wend {
namespace {

struct Entry {
  Status status;
  std::string_view name;
  std::string_view sentence;
};

constexpr std::array kEntries{
    Entry{Status::found, "found", "a path was found"},
    Entry{Status::start_outside, "start_outside", "the start is outside the map"},
    Entry{Status::goal_outside, "goal_outside", "the goal is outside the map"},
    Entry{Status::start_blocked, "start_blocked", "the robot does not fit at the start"},
    Entry{Status::goal_blocked, "goal_blocked", "the robot does not fit at the goal"},
    Entry{Status::unreachable, "unreachable", "there is no path from the start to the goal"},
    Entry{Status::step_limit, "step_limit", "the walk ran out of steps"},
    Entry{Status::expansion_limit, "expansion_limit", "the search reached the limit on expansions"},
    Entry{Status::time_limit, "time_limit", "the search reached the time limit"},
    Entry{Status::memory_limit, "memory_limit", "there is not enough memory for the search"},
    Entry{Status::cancelled, "cancelled", "the search was cancelled"},
    Entry{Status::unsupported_map, "unsupported_map", "this planner does not support the map"},
    Entry{Status::unsupported_query, "unsupported_query",
          "this planner does not support the query"},
    Entry{Status::invalid_option, "invalid_option", "an option is unknown or out of range"},
    Entry{Status::invalid_map, "invalid_map", "the map is invalid"},
    Entry{Status::invalid_file, "invalid_file", "a file is invalid or cannot be read or written"},
    Entry{Status::index_missing, "index_missing", "the planner needs an index and has none"},
    Entry{Status::index_mismatch, "index_mismatch",
          "the index is damaged or belongs to another map"},
};

// to_string and describe index the table by the enum's value.
constexpr bool in_enum_order() {
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    if (static_cast<std::size_t>(kEntries[i].status) != i) return false;
  }
  return true;
}
static_assert(in_enum_order());

}  // namespace

std::string_view to_string(Status status) {
  return kEntries[static_cast<std::size_t>(status)].name;
}

std::string_view describe(Status status) {
  return kEntries[static_cast<std::size_t>(status)].sentence;
}

std::optional<Status> status_from_string(std::string_view name) {
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return entry.status;
  }
  return std::nullopt;
}

}  // namespace wend
