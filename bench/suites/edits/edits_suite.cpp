// What an edit of a map costs, beside making the free space again, in CPU time.
//
// The robot is a disc with a clearance cost. Edits are made in place, at random places of a generated map: each
// time the free space is repaired, and asked whether two cells are connected, as a query does. Then a planner on
// a map for a point robot is asked a query after each edit of a cell.

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measure/measuring.hpp"
#include "bench/suites/edits/next_query.hpp"
#include "bench/suites/suite.hpp"
#include "bench/suites/suite_maps.hpp"
#include "wend/base/random.hpp"
#include "wend/base/thread_time.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::bench {
namespace {

struct Setting {
  std::string_view kind;  // the generator
  int side;               // of the map, in cells
  double radius;          // of the robot, in cells
  double band;            // of its clearance cost, in cells
  double target_scratch;  // seconds
};

constexpr std::array kSettings{Setting{"office", 2048, 4, 7, 40e-3},
                               Setting{"warehouse", 2048, 4, 7, 40e-3},
                               Setting{"office", 4096, 20, 20, 160e-3}};

struct Kind {
  std::string_view name;
  int side;       // of the box, in cells
  double share;   // of its cells that change
  double target;  // seconds, with distances of 11 cells at 2048 x 2048; twice that with others
};

constexpr std::array kKinds{Kind{"one cell", 1, 1, 100e-6},
                            Kind{"a box of 10 x 10, filled or cleared", 10, -1, 250e-6},
                            Kind{"a box of 50 x 50, filled or cleared", 50, -1, 250e-6},
                            Kind{"a sweep over 200 x 200, one cell in 20", 200, 0.05, 1.5e-3}};

std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

bool ask(const FreeSpace& space) {
  const Cell far{space.width() - 11, space.height() - 11};
  return space.components().connected({10, 10}, far, Adjacency::edges);
}

/// An edit of this kind somewhere on the map.
MapEdit random_edit(Random& random, const GridMap& map, const Kind& kind) {
  const int x = random.between(0, map.width() - kind.side);
  const int y = random.between(0, map.height() - kind.side);
  MapEdit edit{.corner = {x, y}, .states = Grid<CellState>(kind.side, kind.side)};
  const bool filled = random.chance(0.5);
  for (const Cell cell : every_cell(edit.states)) {
    const Cell on_map{x + cell.x, y + cell.y};
    const bool was_free = map.state(on_map) == CellState::free;
    const bool changes = kind.share < 0 ? was_free == filled : random.chance(kind.share);
    edit.states[cell] = was_free != changes ? CellState::free : CellState::occupied;
  }
  return edit;
}

struct EditTimes {
  double repair = 0;    // seconds, mean
  double question = 0;  // the first one afterwards
};

EditTimes time_edits(FreeSpace& space, const Kind& kind, int count, Random& random) {
  EditTimes times;
  for (int i = 0; i < count; ++i) {
    const MapEdit edit = random_edit(random, space.map(), kind);
    const double begin = thread_cpu_seconds();
    if (!space.edit(edit)) throw Wrong("an edit was refused");
    const double repaired = thread_cpu_seconds();
    ask(space);
    times.repair += (repaired - begin) / count;
    times.question += (thread_cpu_seconds() - repaired) / count;
  }
  return times;
}

FreeSpaceOptions robot_of(const Setting& setting, double resolution) {
  return {.footprint = Footprint::disc(setting.radius * resolution),
          .clearance_distance = setting.band * resolution};
}

/// The edited space must be the one that is made of the edited map.
void check(const FreeSpace& space) {
  const FreeSpace fresh = *make_free_space(space.map(), space.options());
  const bool equal =
      space.passable() == fresh.passable() &&
      space.components().sizes(Adjacency::edges) == fresh.components().sizes(Adjacency::edges);
  if (!equal) throw Wrong("the edited free space is not that of the edited map");
  for (const Cell cell : every_cell(space)) {
    if (space.terrain(cell) != fresh.terrain(cell)) throw Wrong("an edited cost is wrong");
  }
}

void run(const Setting& setting, int count, std::uint64_t seed) {
  const GridMap map = generated_map(setting.kind, setting.side, setting.side, {}, seed);
  const FreeSpaceOptions robot = robot_of(setting, map.frame().resolution);
  const Clock clock = thread_cpu_seconds;
  const double scratch = least_seconds(clock, [&] { ask(*make_free_space(map, robot)); });
  const std::size_t before = allocated_bytes();
  FreeSpace space = *make_free_space(map, robot);
  ask(space);
  const double bytes =
      static_cast<double>(allocated_bytes() - before) / static_cast<double>(map.size());
  fmt::print(
      "{} {} x {}, distances of {:g} cells: from scratch {:.1f} ms (target {:.0f}), {:.2f} bytes a "
      "cell\n",
      setting.kind, setting.side, setting.side, setting.radius + setting.band, 1e3 * scratch,
      1e3 * setting.target_scratch, bytes);
  fmt::print("  {:<42} {:>9} {:>11} {:>9} {:>9} {:>8}\n", "", "repair us", "question us", "both us",
             "target us", "faster");
  Random random(seed);
  const bool small = setting.side <= 2048;
  time_edits(space, kKinds.front(), 1, random);  // takes the map for itself
  for (const Kind& kind : kKinds) {
    const EditTimes times = time_edits(space, kind, count, random);
    const double both = times.repair + times.question;
    fmt::print("  {:<42} {:>9.1f} {:>11.1f} {:>9.1f} {:>9.0f} {:>8.0f}\n", kind.name,
               1e6 * times.repair, 1e6 * times.question, 1e6 * both,
               1e6 * kind.target * (small ? 1 : 2), scratch / both);
  }
  check(space);
}

/// One line for each kind of map.
int run_next_queries(const std::string& planner, int side, int count, std::uint64_t seed) {
  fmt::print(
      "{}, {} x {}, a point robot: an edit of one cell and the next query, us (target of both "
      "1000); "
      "a query without\nan edit; the first query on a new space. The planner has answered these "
      "queries "
      "before.\n"
      "  {:<12} {:>9} {:>9} {:>9} {:>9} {:>10} {:>9}\n",
      planner, side, side, "", "edit", "query", "both", "longest", "no edit", "first");
  int wrong = 0;
  for (const std::string_view kind : {"office", "warehouse", "rooms", "maze", "random"}) {
    const auto row = time_next_queries(kind, side, planner, count, seed);
    fmt::print("  {:<12} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>10.1f} {:>9.1f}{}\n", kind,
               1e6 * row.edit, 1e6 * row.next, 1e6 * (row.edit + row.next), 1e6 * row.worst,
               1e6 * row.unedited, 1e6 * row.first_one, row.wrong > 0 ? "  WRONG" : "");
    wrong += row.wrong;
  }
  return wrong == 0 ? 0 : 1;
}

}  // namespace

Measure add_edits(CLI::App& app) {
  struct Arguments {
    int count = 200;
    std::uint64_t seed = 7;
    std::string planner = "jps";
    bool only_planner = false;
    int side = 2048;
  };
  const auto arguments = std::make_shared<Arguments>();
  app.add_option("--count", arguments->count, "edits of each kind; their mean is shown")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--seed", arguments->seed, "of the maps and the edits")->capture_default_str();
  app.add_option("--planner", arguments->planner, "asked a query after each edit")
      ->capture_default_str();
  app.add_flag("--only-planner", arguments->only_planner, "leave out the repairs of free spaces");
  app.add_option("--side", arguments->side, "of the planner's maps, in cells")
      ->check(CLI::Range(16, 16384))
      ->capture_default_str();
  return [arguments] {
    stay_on_one_core();
    if (!arguments->only_planner) {
      for (const Setting& setting : kSettings) run(setting, arguments->count, arguments->seed);
    }
    return run_next_queries(arguments->planner, arguments->side, std::min(arguments->count, 100),
                            arguments->seed);
  };
}

}  // namespace wend::bench
