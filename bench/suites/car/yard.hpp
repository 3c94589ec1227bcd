#pragma once

// The yards that the car is timed on. All planners get the same drives on a yard.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "wend/planner/plan.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {

struct Yard {
  std::string name;
  FreeSpace space;
  std::vector<Query> drives;  // the first one from corner to corner; a drive exists for each
};

struct YardPlan {
  int size = 2000;         // cells along each side
  std::size_t drives = 5;  // on each yard
  std::uint64_t seed = 1;
};

/// Random obstacles on 12 % of the cells, the same with as many rough cells, and a parking yard.
std::vector<Yard> make_yards(const YardPlan& plan);

}  // namespace wend::bench
