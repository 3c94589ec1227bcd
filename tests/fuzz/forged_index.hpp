#pragma once

// Indexes that are forged: their checksum, planner, version and map are right, and what is behind them
// is whatever the bytes say. Such an index may be refused or answer wrongly; nothing else.

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planners.hpp"

namespace wend::test {

inline FreeSpace space_for_forgery(const FreeSpaceOptions& robot) {
  constexpr std::array<std::string_view, 8> kRows{"....#...........", ".##.#.#####.##..",  //
                                                  ".#..#.....#..#..", ".#.####.#.##.#..",  //
                                                  ".....#..#....#..", "##.#...###.###..",  //
                                                  "...#.#...#......", ".#...#.#...#.#.."};
  Grid<CellState> cells(static_cast<int>(kRows.front().size()), static_cast<int>(kRows.size()),
                        CellState::free);
  for (int y = 0; y < cells.height(); ++y) {
    for (int x = 0; x < cells.width(); ++x) {
      if (kRows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#') {
        cells[{x, y}] = CellState::occupied;
      }
    }
  }
  return *make_free_space(*make_grid_map(cells), robot);
}

/// Asks for all pairs of some cells.
inline void ask(Planner& planner) {
  Plan plan;
  for (int start = 0; start < 16; start += 3) {
    for (int goal = 0; goal < 128; goal += 5) {
      planner.plan(Query::between({start, 4}, {goal % 16, goal / 16}), plan);
    }
  }
}

/// Three bytes each: where behind the header (two of them), and what stands there then.
inline std::vector<std::byte> forged(std::span<const std::byte> index, std::string_view changes) {
  std::vector<std::byte> bytes(index.begin(), index.end());
  const std::size_t room = bytes.size() - sizeof(IndexHeader);
  for (std::size_t i = 0; i + 2 < changes.size() && room > 0; i += 3) {
    const auto high = static_cast<unsigned char>(changes[i]);
    const auto low = static_cast<unsigned char>(changes[i + 1]);
    bytes[sizeof(IndexHeader) + (high * 256U + low) % room] =
        static_cast<std::byte>(changes[i + 2]);
  }
  IndexHeader header;
  std::memcpy(&header, bytes.data(), sizeof header);
  header.checksum = index_file::checksum_of(bytes);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

struct WholeIndex {
  const PlannerInfo* planner;
  IndexBytes bytes;
};

inline const std::vector<WholeIndex>& whole_indexes(const FreeSpace& space) {
  static const std::vector<WholeIndex> indexes = [&] {
    std::vector<WholeIndex> built;
    for (const PlannerInfo& info : planners()) {
      if (info.index_support)
        built.push_back({&info, info.index_support->build(space, {}).value()});
    }
    return built;
  }();
  return indexes;
}

/// Forges an index of every planner; what is wrong, empty if nothing is.
inline std::string use_forged_indexes(std::string_view changes) {
  static const FreeSpace space = space_for_forgery({});
  // A disc that fits in the same cells, but not along every path of a point.
  static const FreeSpace of_disc = space_for_forgery({.footprint = Footprint::disc(0.49)});
  for (const WholeIndex& index : whole_indexes(space)) {
    const auto bytes = forged(index.bytes.bytes(), changes);
    for (const FreeSpace* const robot : {&space, &of_disc}) {
      const auto planner =
          index.planner->index_support->make_planner(*robot, {}, IndexBytes::copy_of(bytes));
      if (planner) {
        ask(**planner);
      } else if (planner.error().status != Status::index_mismatch) {
        return index.planner->name + ": refused as " +
               std::string(to_string(planner.error().status));
      }
    }
  }
  return {};
}

}  // namespace wend::test
