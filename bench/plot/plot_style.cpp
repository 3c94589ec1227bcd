#include "bench/plot/plot_style.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace wend {
namespace {

constexpr std::size_t kColours = kLightPlot.names.size();

/// Planners are never compared with controllers.
constexpr std::array<std::pair<std::string_view, std::size_t>, 25> kOwn{{
    {"astar", 0},
    {"dijkstra", 1},
    {"jps", 2},
    {"hub_labels", 3},
    {"boost-astar", 5},
    {"greedy", 6},
    {"bfs", 7},
    {"dfs", 8},
    {"random_walk", 9},
    {"car", 10},
    {"theta_star", 11},
    {"lazy_theta_star", 12},
    {"lattice", 13},
    {"alt", 14},
    {"replanner", 15},
    {"d_star_lite", 16},
    {"hybrid_astar", 17},
    {"any_angle", 18},
    {"ara_star", 19},
    {"euclidean_labels", 20},
    {"p", 0},
    {"p_moving", 1},
    {"pid", 2},
    {"pure_pursuit", 3},
    {"stanley", 4},
}};

/// "car:weight=2" has the colour of "car".
std::optional<std::size_t> own_colour(std::string_view name) {
  const std::string_view base = name.substr(0, name.find(':'));
  const auto* const own = std::ranges::find(kOwn, base, &decltype(kOwn)::value_type::first);
  if (own == kOwn.end()) return std::nullopt;
  return own->second;
}

}  // namespace

std::vector<std::size_t> plot_colours_of(std::span<const std::string> names) {
  std::vector<std::optional<std::size_t>> colours(names.size());
  std::vector<bool> taken(kColours);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto own = own_colour(names[i]);
    if (!own || taken[*own]) continue;
    colours[i] = own;
    taken[*own] = true;
  }
  std::vector<std::size_t> all(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto free = std::ranges::find(taken, false);
    const auto other =
        free != taken.end() ? static_cast<std::size_t>(free - taken.begin()) : i % kColours;
    all[i] = colours[i].value_or(other);
    taken[all[i]] = true;
  }
  return all;
}

}  // namespace wend
