#include "wend/index/hierarchy_search.hpp"

namespace wend {

void HierarchySearch::forget() {
  for (const std::uint32_t node : touched_) labels_[node] = {};
  touched_.clear();
  queues_[forward].clear();
  queues_[backward].clear();
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
    append_arc(forward, climb_[i], climb_[i - 1], nodes);
  }
  for (std::uint32_t node = meeting_; labels_[node].from[backward] != kNoNode;) {
    const std::uint32_t next = labels_[node].from[backward];
    append_arc(backward, next, node, nodes);
    node = next;
  }
}

/// Appends the nodes of an arc, without its tail.
void HierarchySearch::append_arc(Side side, std::uint32_t owner, std::uint32_t other,
                                 std::vector<std::uint32_t>& nodes) {
  const auto& arcs = side == forward ? hierarchy_.leaving : hierarchy_.entering;
  const HierarchyNode& begin = hierarchy_.begins[owner];
  std::uint32_t arc = side == forward ? begin.leaving : begin.entering;
  while (arcs[arc].node != other) ++arc;
  pieces_.push_back({side, arc});
  while (!pieces_.empty()) {
    const Piece piece = pieces_.back();
    pieces_.pop_back();
    const auto& vias = piece.side == forward ? hierarchy_.leaving_vias : hierarchy_.entering_vias;
    const HierarchyVia& via = vias[piece.arc];
    if (via.shortcut()) {
      pieces_.push_back({forward, via.leaving});
      pieces_.push_back({backward, via.entering});
    } else {
      nodes.push_back(via.head());
    }
  }
}

}  // namespace wend
