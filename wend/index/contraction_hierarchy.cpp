#include "wend/index/contraction_hierarchy.hpp"

#include <vector>

namespace wend {
namespace {

/// Checks arrays piece by piece, each piece after what it relies on.
class Inspection {
 public:
  explicit Inspection(const ContractionHierarchy& hierarchy) : hierarchy_(hierarchy) {}

  bool sizes_fit() const {
    const auto& [begins, leaving, entering, leaving_vias, entering_vias, core_begin] = hierarchy_;
    return !begins.empty() && begins.size() <= HierarchyVia::kNoArc && core_begin < begins.size() &&
           leaving.size() < HierarchyVia::kNoArc && entering.size() < HierarchyVia::kNoArc &&
           leaving.size() == leaving_vias.size() && entering.size() == entering_vias.size();
  }

  bool begins_ascend() const {
    HierarchyNode last;
    for (const HierarchyNode& begin : hierarchy_.begins) {
      if (begin.leaving < last.leaving || begin.entering < last.entering) return false;
      last = begin;
    }
    const HierarchyNode& first = hierarchy_.begins.front();
    return first.leaving == 0 && first.entering == 0 && last.leaving == hierarchy_.leaving.size() &&
           last.entering == hierarchy_.entering.size();
  }

  void find_owners() {
    leaving_owners_.reserve(hierarchy_.leaving.size());
    entering_owners_.reserve(hierarchy_.entering.size());
    for (std::uint32_t node = 0; node < hierarchy_.size(); ++node) {
      leaving_owners_.insert(leaving_owners_.end(), hierarchy_.leaving_of(node).size(), node);
      entering_owners_.insert(entering_owners_.end(), hierarchy_.entering_of(node).size(), node);
    }
  }

  bool leaving_is_sound(std::uint32_t arc) const {
    const HierarchyArc& is = hierarchy_.leaving[arc];
    const HierarchyVia& via = hierarchy_.leaving_vias[arc];
    const std::uint32_t owner = leaving_owners_[arc];
    if (!climbs(owner, is)) return false;
    return via.shortcut() ? is_made_of(owner, is.node, is.cost, via, owner) : via.head() == is.node;
  }

  bool entering_is_sound(std::uint32_t arc) const {
    const HierarchyArc& is = hierarchy_.entering[arc];
    const HierarchyVia& via = hierarchy_.entering_vias[arc];
    const std::uint32_t owner = entering_owners_[arc];
    if (hierarchy_.in_core(owner) || !climbs(owner, is)) return false;
    return via.shortcut() ? is_made_of(is.node, owner, is.cost, via, owner) : via.head() == owner;
  }

 private:
  bool climbs(std::uint32_t owner, const HierarchyArc& arc) const {
    if (arc.node >= hierarchy_.size() || arc.node == owner || arc.cost == 0) return false;
    return hierarchy_.in_core(owner) ? hierarchy_.in_core(arc.node) : arc.node > owner;
  }

  bool is_made_of(std::uint32_t tail, std::uint32_t head, HierarchyCost cost,
                  const HierarchyVia& via, std::uint32_t owner) const {
    if (via.entering >= entering_owners_.size() || via.leaving >= leaving_owners_.size()) {
      return false;
    }
    const std::uint32_t middle = entering_owners_[via.entering];
    const HierarchyArc& first = hierarchy_.entering[via.entering];
    const HierarchyArc& second = hierarchy_.leaving[via.leaving];
    return middle < owner && middle == leaving_owners_[via.leaving] && first.node == tail &&
           second.node == head && std::uint64_t{first.cost} + second.cost == cost;
  }

  ContractionHierarchy hierarchy_;
  std::vector<std::uint32_t> leaving_owners_;
  std::vector<std::uint32_t> entering_owners_;
};

}  // namespace

std::optional<std::string> fault_of(const ContractionHierarchy& hierarchy) {
  Inspection inspection(hierarchy);
  if (!inspection.sizes_fit()) return "its arrays do not fit each other";
  if (!inspection.begins_ascend()) return "the arcs of its nodes overlap";
  inspection.find_owners();
  for (std::uint32_t arc = 0; arc < hierarchy.leaving.size(); ++arc) {
    if (!inspection.leaving_is_sound(arc)) return "an arc that leaves a node makes no sense";
  }
  for (std::uint32_t arc = 0; arc < hierarchy.entering.size(); ++arc) {
    if (!inspection.entering_is_sound(arc)) return "an arc that enters a node makes no sense";
  }
  return std::nullopt;
}

}  // namespace wend
