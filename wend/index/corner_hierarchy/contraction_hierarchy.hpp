#pragma once

// ContractionHierarchy: a directed graph whose nodes are ordered by height, so that a search only
// climbs. (R. Geisberger, P. Sanders, D. Schultes, D. Delling, "Contraction Hierarchies", 2008;
// with a core as in R. Bauer et al., "Combining Hierarchical and Goal-Directed Speed-Up
// Techniques", 2010.)
//
// Nodes were contracted one by one, from 0 up; where a shortest path led through a contracted node, a
// shortcut replaces it. So there is a shortest path between any two nodes that first climbs,
// along arcs to higher nodes, and then descends. The nodes from core() on were not contracted: they
// are the top, all at one height, joined by all their arcs.
//
// A node stores the arcs between itself and higher nodes: those that leave it, and those that enter
// it. A node of the core stores all arcs that leave it within the core, and no entering arcs.
//
// A view of flat arrays that lie elsewhere, for example in an index file.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace wend {

using HierarchyCost = std::uint32_t;

/// An arc as its owner stores it: `node` is where it leads to (leaving) or comes from (entering).
struct HierarchyArc {
  std::uint32_t node = 0;
  HierarchyCost cost = 0;

  friend bool operator==(const HierarchyArc&, const HierarchyArc&) = default;
};

/// What an arc represents. A shortcut stores the numbers of two arcs: one enters a lower node and one
/// leaves it. An arc of the graph stores kNoArc and its head.
struct HierarchyVia {
  static constexpr std::uint32_t kNoArc = static_cast<std::uint32_t>(-1);

  std::uint32_t entering = kNoArc;
  std::uint32_t leaving = 0;

  bool shortcut() const { return entering != kNoArc; }
  std::uint32_t head() const { return leaving; }

  friend bool operator==(const HierarchyVia&, const HierarchyVia&) = default;
};

/// Where the arcs of a node begin: first those that leave it, then those that enter it, which end
/// where the next node begins.
struct HierarchyNode {
  std::uint32_t leaving = 0;
  std::uint32_t entering = 0;

  friend bool operator==(const HierarchyNode&, const HierarchyNode&) = default;
};

struct ContractionHierarchy {
  std::span<const HierarchyNode> nodes;  // and the end
  std::span<const HierarchyArc> arcs;
  std::span<const HierarchyVia> vias;  // by number of the arc
  std::uint32_t core_begin = 0;

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes.size() - 1); }
  bool in_core(std::uint32_t node) const { return node >= core_begin; }

  std::span<const HierarchyArc> leaving_of(std::uint32_t node) const {
    return arcs.subspan(nodes[node].leaving, nodes[node].entering - nodes[node].leaving);
  }
  std::span<const HierarchyArc> entering_of(std::uint32_t node) const {
    return arcs.subspan(nodes[node].entering, nodes[node + 1].leaving - nodes[node].entering);
  }
};

/// What is wrong with arrays from an untrusted file; nullopt if a search may use them: all numbers are
/// in range, arcs climb, shortcuts consist of arcs of a lower node and cost the sum of these, and no arc
/// costs 0. O(nodes + arcs).
std::optional<std::string> fault_of(const ContractionHierarchy& hierarchy);

}  // namespace wend
