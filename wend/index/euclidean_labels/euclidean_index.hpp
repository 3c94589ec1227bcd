#pragma once

// The Euclidean label index of a map: it looks up the shortest path of a point at any angle between any two cells.
//
// Idea. A shortest path is straight or turns at corners of obstacles, and is taut there. Every corner has a label: some
// hubs and the lengths of the taut paths to them (taut_labelling.hpp). A cell looks up the corners that it sees, and
// of each the part of its label whose paths go on taut from there (taut_label_sections.hpp). A query notes the lengths
// by which the start reaches hubs, finds the hub that gives the least sum to the goal, and follows the entries of both
// sides to it. (J. Du, B. Shen and M. A. Cheema, "Ultrafast Euclidean Shortest Path Computation Using Hub Labeling",
// 2023, keep the corners seen and the labels of regions instead.)
//
// A path does not pass between two cells that touch diagonally, the other two being blocked.
//
// Limits: 65536 corners; 256 bytes a cell and 4 MiB for what corners see, while the index is built; no path to a hub may
// be longer than 16.7 million cells.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/geometry/cell.hpp"
#include "wend/index/euclidean_labels/taut_label_sections.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/map/bit_grid.hpp"
#include "wend/search/search_outcome.hpp"
#include "wend/sight/portals.hpp"

namespace wend {

inline constexpr std::string_view kEuclideanLabels = "euclidean_labels";

/// Builds the index of the passable cells. Errors: cancelled or unsupported_map. The bytes are the same in every run.
Expected<IndexBytes, Error> build_euclidean_index(const BitGrid& passable,
                                                  const IndexBuilding& building);

/// Answers queries from an index that threads share. Each thread needs its own engine.
class EuclideanEngine {
 public:
  /// Checks the index, or says what is wrong with it (index_mismatch). O(bytes).
  static Expected<std::unique_ptr<EuclideanEngine>, Error> open(IndexBytes index,
                                                                const BitGrid& passable);

  /// Finds the shortest path between two free cells. False if the index knows none.
  bool find(Cell start, Cell goal);

  /// The length of that path, in cells, to about 1e-10. Its corners give it more exactly.
  double length() const { return length_; }
  const Portals& portals() const { return portals_; }
  /// The corners of Portals at which the path of the last find() turns, from the start to the goal. Those on a straight
  /// line are among them.
  std::span<const std::uint32_t> corners() const { return path_; }
  /// The work of the last find().
  const SearchMetrics& metrics() const { return metrics_; }

 private:
  static constexpr std::uint32_t kItself =
      UINT32_MAX;  // instead of an entry: the corner is the hub

  /// A corner by its hub, in half cells.
  struct Place {
    std::int32_t x;
    std::int32_t y;
  };

  /// How the start reaches a hub.
  struct Reached {
    TautLength length = kNoTautLength;
    std::uint32_t entry = kItself;
  };

  /// The best path so far, by a hub.
  struct Way {
    TautLength length = kNoTautLength;
    std::uint32_t hub = 0;
    std::uint32_t from_start = kItself;  // entries
    std::uint32_t from_goal = kItself;
  };

  EuclideanEngine(IndexBytes index, Portals portals, const TautLabelSections& sections);

  template <class Visit>
  void for_each_hub(Cell cell, Visit&& visit);
  void append_corners(std::uint32_t entry);

  IndexBytes index_;  // keeps what the sections show
  Portals portals_;
  TautLabelSections sections_;
  std::size_t blocks_a_row_;
  std::vector<Place> places_;     // of each hub
  std::vector<Reached> reached_;  // of each hub; kNoTautLength between queries
  std::vector<std::uint32_t> touched_;
  std::vector<std::uint32_t> path_;
  double length_ = 0;
  SearchMetrics metrics_;
};

}  // namespace wend
