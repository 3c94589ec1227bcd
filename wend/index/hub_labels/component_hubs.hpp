#pragma once

// ComponentHubs: which hubs the cells of a component need, by which of their first corners.
//
// A cell reaches a hub at the least cost over its first corners. It does not need a hub if the way
// there can pass a more important one that it reaches: then that one serves every goal as well. A
// hub is kept for a component if any of its cells needs it, by a corner that gives the least cost to a
// cell that does; testing some of the cells only would be wrong.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "wend/index/corners.hpp"
#include "wend/index/hub_labels/hub_labelling.hpp"

namespace wend {

class ComponentHubs {
 public:
  /// Of a complete labelling. Both must outlive it. One a thread.
  ComponentHubs(const Corners& corners, const HubLabelling& labelling);

  /// For cells that all have these first corners: the hubs that each corner is kept for, in their
  /// order. Valid until the next call.
  std::span<const std::vector<HubEntry>> choose(std::span<const Cell> cells,
                                                std::span<const std::uint32_t> first);

 private:
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  /// How a hub is reached from the cell in hand.
  struct Reached {
    CornerCost cost;
    CornerCost from_corner;
    std::uint32_t by;  // the place of a first corner
  };

  void list_hubs(std::span<const std::uint32_t> first);
  void reach_hubs(Cell cell, std::span<const std::uint32_t> first);
  void keep_what_is_needed(Cell cell, std::span<const std::uint32_t> first);
  bool is_kept(Cell cell, std::span<const std::uint32_t> first, std::size_t slot) const;
  bool is_needed(std::size_t slot) const;

  const Corners& corners_;
  const HubLabelling& labelling_;
  std::vector<std::uint32_t> slots_;           // by hub: its place in hubs_, or none
  std::vector<std::uint32_t> hubs_;            // of the component, in their order
  std::vector<Reached> reached_;               // by slot
  std::vector<std::vector<Reached>> kept_by_;  // by slot
  std::vector<std::vector<HubEntry>> chosen_;  // by first corner
};

}  // namespace wend
