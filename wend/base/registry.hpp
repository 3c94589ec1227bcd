#pragma once

// A list of named things that can be chosen at run time: planners, generators, later smoothers and
// controllers. T has a member `name` that converts to std::string.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/suggestion.hpp"

namespace wend {

template <class T>
class Registry {
 public:
  /// The order of the entries is the order in which front ends list them.
  explicit Registry(std::vector<T> entries) : entries_(std::move(entries)) {}

  /// The entry of that name, or null.
  const T* find(std::string_view name) const {
    for (const T& entry : entries_) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(entries_.size());
    for (const T& entry : entries_) names.emplace_back(entry.name);
    return names;
  }

  /// What to tell a user who typed a name that is not here: "there is no planner 'astr': did you
  /// mean 'astar'?", or all names where none is near.
  std::string unknown(std::string_view kind, std::string_view typed) const {
    std::string text = "there is no " + std::string(kind) + " '" + std::string(typed) + "'";
    const std::vector<std::string> known = names();
    if (const auto closest = closest_name(typed, known)) {
      return text + ": did you mean '" + *closest + "'?";
    }
    text += ": choose from";
    for (std::size_t i = 0; i < known.size(); ++i) text += (i == 0 ? " " : ", ") + known[i];
    return text;
  }

  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.end(); }
  std::size_t size() const { return entries_.size(); }

 private:
  std::vector<T> entries_;
};

}  // namespace wend
