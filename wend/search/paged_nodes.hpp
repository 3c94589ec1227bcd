#pragma once

// PagedNodes: search nodes in pages, which are allocated when a search first opens a state of the page. For
// spaces with many states of which a search needs those near each other. See node_table.hpp for the nodes.
//
// One more load than a NodeTable: a search of a lattice takes a tenth longer. Its memory does not depend on how
// the system gives memory out. Pages stay for later searches, which start in O(1); references to nodes stay
// valid.

#include <cstddef>
#include <cstdlib>
#include <memory>

#include "wend/search/node_table.hpp"

namespace wend {

template <class NodeType, unsigned kGenerationBits = kNodeGenerationBits>
class PagedNodes {
 public:
  using Node = NodeType;
  static constexpr bool kGrows = true;

  explicit PagedNodes(StateId count)
      : page_count_((std::size_t{count} + kPageSize - 1) / kPageSize),
        pages_(static_cast<Node**>(std::calloc(page_count_, sizeof(Node*)))) {}

  PagedNodes(const PagedNodes&) = delete;
  PagedNodes& operator=(const PagedNodes&) = delete;
  ~PagedNodes() {
    if (pages_ == nullptr) return;
    for (std::size_t page = 0; page < page_count_; ++page) std::free(pages_[page]);
  }

  /// False if the system had no memory for the list of pages.
  bool allocated() const { return pages_ != nullptr; }

  /// Invalidates all nodes. O(1) except when generations run out.
  void begin_search() {
    generations_.advance([this](auto&& invalidate) {
      for (std::size_t page = 0; page < page_count_; ++page) {
        if (pages_[page] == nullptr) continue;
        for (StateId i = 0; i < kPageSize; ++i) invalidate(pages_[page][i]);
      }
    });
  }

  /// The node of a state; one that is not reached() if no search has opened a state of its page.
  const Node& operator[](StateId id) const {
    const Node* const page = pages_[id / kPageSize];
    return page == nullptr ? kUnreached : page[id % kPageSize];
  }
  /// For a state that this search has reached.
  Node& operator[](StateId id) { return pages_[id / kPageSize][id % kPageSize]; }

  /// The node to open for a state; null if there is no memory for its page.
  Node* room_for(StateId id) {
    Node*& page = pages_[id / kPageSize];
    if (page == nullptr) page = static_cast<Node*>(std::calloc(kPageSize, sizeof(Node)));
    return page == nullptr ? nullptr : &page[id % kPageSize];
  }

  /// Has this search reached the node?
  bool reached(const Node& node) const { return generations_.is_current(node); }

  /// Opens a node, for the first time or again.
  void open(Node& node, decltype(Node::g) g, typename Node::Arrival arrival) {
    generations_.open(node, g, arrival);
  }

 private:
  static constexpr StateId kPageSize = 256;  // nodes: 4 KiB of 16 bytes each
  static constexpr Node kUnreached{};

  NodeGenerations<Node, kGenerationBits> generations_;
  std::size_t page_count_;
  std::unique_ptr<Node*[], FreeMemory> pages_;  // null: not allocated yet
};

}  // namespace wend
