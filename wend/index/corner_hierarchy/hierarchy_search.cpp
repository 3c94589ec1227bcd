#include "wend/index/corner_hierarchy/hierarchy_search.hpp"

namespace wend {

void HierarchySearch::forget() {
  for (const std::uint32_t node : touched_) labels_[node] = {};
  touched_.clear();
  meeting_ = kNoNode;
  metrics_ = {};
}

void HierarchySearch::append_nodes(std::vector<std::uint32_t>& nodes) {
  climb_.clear();
  for (std::uint32_t node = meeting_; node != kNoNode; node = labels_[node].from[forward]) {
    climb_.push_back(node);
  }
  nodes.push_back(climb_.back());
  for (std::size_t i = climb_.size() - 1; i > 0; --i) {
    append_arc(hierarchy_.leaving_of(climb_[i]), climb_[i - 1], nodes);
  }
  for (std::uint32_t node = meeting_; labels_[node].from[backward] != kNoNode;) {
    const std::uint32_t next = labels_[node].from[backward];
    append_arc(hierarchy_.entering_of(next), node, nodes);
    node = next;
  }
}

/// Appends the nodes of the arc to `to`, or from it, without its tail.
void HierarchySearch::append_arc(std::span<const HierarchyArc> arcs, std::uint32_t to,
                                 std::vector<std::uint32_t>& nodes) {
  const HierarchyArc* arc = arcs.data();
  while (arc->node != to) ++arc;
  pieces_.push_back(static_cast<std::uint32_t>(arc - hierarchy_.arcs.data()));
  while (!pieces_.empty()) {
    const HierarchyVia& via = hierarchy_.vias[pieces_.back()];
    pieces_.pop_back();
    if (via.shortcut()) {
      pieces_.push_back(via.leaving);
      pieces_.push_back(via.entering);
    } else {
      nodes.push_back(via.head());
    }
  }
}

}  // namespace wend
