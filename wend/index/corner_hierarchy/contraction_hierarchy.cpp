#include "wend/index/corner_hierarchy/contraction_hierarchy.hpp"

#include <vector>

namespace wend {
namespace {

/// Checks the arrays part by part, each part after those that it relies on.
class Inspection {
 public:
  explicit Inspection(const ContractionHierarchy& hierarchy) : hierarchy_(hierarchy) {}

  bool sizes_fit() const {
    const auto& [nodes, arcs, vias, core_begin] = hierarchy_;
    return !nodes.empty() && nodes.size() <= HierarchyVia::kNoArc && core_begin < nodes.size() &&
           arcs.size() < HierarchyVia::kNoArc && arcs.size() == vias.size();
  }

  bool begins_ascend() const {
    std::uint32_t last = 0;
    for (const HierarchyNode& node : hierarchy_.nodes) {
      if (node.leaving < last || node.entering < node.leaving) return false;
      last = node.entering;
    }
    const HierarchyNode& end = hierarchy_.nodes.back();
    return hierarchy_.nodes.front().leaving == 0 && end.leaving == hierarchy_.arcs.size() &&
           end.entering == end.leaving;
  }

  void find_owners() {
    owners_.reserve(hierarchy_.arcs.size());
    for (std::uint32_t node = 0; node < hierarchy_.size(); ++node) {
      const std::uint32_t end = hierarchy_.nodes[node + 1].leaving;
      owners_.insert(owners_.end(), end - hierarchy_.nodes[node].leaving, node);
    }
  }

  bool is_sound(std::uint32_t number) const {
    const HierarchyArc& arc = hierarchy_.arcs[number];
    const HierarchyVia& via = hierarchy_.vias[number];
    const std::uint32_t owner = owners_[number];
    const bool leaving = leaves(number);
    if (!climbs(owner, arc) || (hierarchy_.in_core(owner) && !leaving)) return false;
    const std::uint32_t tail = leaving ? owner : arc.node;
    const std::uint32_t head = leaving ? arc.node : owner;
    return via.shortcut() ? is_made_of(tail, head, arc.cost, via, owner) : via.head() == head;
  }

 private:
  /// True if the arc leaves its owner, false if it enters it.
  bool leaves(std::uint32_t number) const {
    return number < hierarchy_.nodes[owners_[number]].entering;
  }

  bool climbs(std::uint32_t owner, const HierarchyArc& arc) const {
    if (arc.node >= hierarchy_.size() || arc.node == owner || arc.cost == 0) return false;
    return hierarchy_.in_core(owner) ? hierarchy_.in_core(arc.node) : arc.node > owner;
  }

  bool is_made_of(std::uint32_t tail, std::uint32_t head, HierarchyCost cost,
                  const HierarchyVia& via, std::uint32_t owner) const {
    if (via.entering >= owners_.size() || via.leaving >= owners_.size()) return false;
    const std::uint32_t middle = owners_[via.entering];
    const HierarchyArc& first = hierarchy_.arcs[via.entering];
    const HierarchyArc& second = hierarchy_.arcs[via.leaving];
    return middle < owner && middle == owners_[via.leaving] && !leaves(via.entering) &&
           leaves(via.leaving) && first.node == tail && second.node == head &&
           std::uint64_t{first.cost} + second.cost == cost;
  }

  ContractionHierarchy hierarchy_;
  std::vector<std::uint32_t> owners_;  // by arc
};

}  // namespace

std::optional<std::string> fault_of(const ContractionHierarchy& hierarchy) {
  Inspection inspection(hierarchy);
  if (!inspection.sizes_fit()) return "the sizes of its arrays do not match";
  if (!inspection.begins_ascend()) return "the arcs of its nodes overlap";
  inspection.find_owners();
  for (std::uint32_t arc = 0; arc < hierarchy.arcs.size(); ++arc) {
    if (!inspection.is_sound(arc)) return "an arc is invalid";
  }
  return std::nullopt;
}

}  // namespace wend
