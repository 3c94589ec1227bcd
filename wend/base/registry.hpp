#pragma once

// Registry: a list of named entries that can be chosen at run time (planners, generators, smoothers,
// controllers), and suggestions for users who misspell a name.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"

namespace wend {

/// The name with the smallest edit distance to `typed` (letters inserted, deleted, changed or swapped
/// with a neighbour), if at most a third of its letters differ. O(|typed| * total length of names).
WEND_API std::optional<std::string> closest_name(std::string_view typed,
                                                 std::span<const std::string> names);

/// "astar, bfs, dfs".
WEND_API std::string listed(std::span<const std::string> names);

/// "did you mean 'astar'?", or "choose from astar, bfs, dfs" if no name is similar.
WEND_API std::string suggestion(std::string_view typed, std::span<const std::string> names);

/// "there is no planner 'astr': did you mean 'astar'?"
WEND_API std::string unknown_name(std::string_view kind, std::string_view typed,
                                  std::span<const std::string> names);

/// A list of named entries. T has a member `name` that converts to std::string.
template <class T>
class Registry {
 public:
  /// The order of the entries is the order in which front ends list them.
  explicit Registry(std::vector<T> entries) : entries_(std::move(entries)) {}

  /// The entry with this name, or null.
  const T* find(std::string_view name) const {
    for (const T& entry : entries_) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

  /// The same, or invalid_option with unknown_name().
  Expected<const T*, Error> named(std::string_view kind, std::string_view name) const {
    if (const T* entry = find(name)) return entry;
    return failure(Status::invalid_option, unknown(kind, name), std::string(name));
  }

  /// The names of the entries, in their order.
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(entries_.size());
    for (const T& entry : entries_) names.emplace_back(entry.name);
    return names;
  }

  /// unknown_name() with the names of the entries.
  std::string unknown(std::string_view kind, std::string_view typed) const {
    return unknown_name(kind, typed, names());
  }

  /// The first entry.
  auto begin() const { return entries_.begin(); }
  /// Behind the last entry.
  auto end() const { return entries_.end(); }
  /// The number of entries.
  std::size_t size() const { return entries_.size(); }

 private:
  std::vector<T> entries_;
};

}  // namespace wend
