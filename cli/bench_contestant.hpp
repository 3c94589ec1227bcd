#pragma once

// What `wend bench` compares: planners with their options.

#include <memory>
#include <string>
#include <vector>

#include "wend/map/free_space.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_spec.hpp"

namespace wend::cli {

class Contestant {
 public:
  explicit Contestant(PlannerSpec spec);

  /// As it was typed: "astar:weight=2".
  const std::string& name() const { return spec_.text; }

  /// A planner for one thread. Throws InputError if it does not take its options or the map.
  std::unique_ptr<Planner> make_planner(const FreeSpace& space) const;

 private:
  PlannerSpec spec_;
};

/// Those of a --planner list. Throws InputError for one that is not there, and for one that does not
/// move as scenarios ask for: on 8 neighbours, without corner cutting.
std::vector<Contestant> parse_contestants(const std::string& list);

}  // namespace wend::cli
