#pragma once

// ConsistentNodes: the nodes of D* Lite. Each has g, its cost, and rhs, the cost that its neighbours imply. Nodes
// where the two differ are open: they wait in a heap, ordered by key, in which each has one place.
//
// begin() takes O(1): what was touched before is forgotten by its number of the search.

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "wend/base/state_id.hpp"
#include "wend/base/zeroed_memory.hpp"

namespace wend {

class ConsistentNodes {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  struct Key {
    std::uint64_t first;   // the cost and the estimate
    std::uint64_t second;  // the cost

    friend auto operator<=>(const Key&, const Key&) = default;
  };

  explicit ConsistentNodes(StateId count) : nodes_(zeroed_table<Node>(count)) {}

  /// False if the system had no memory for them.
  bool allocated() const { return nodes_ != nullptr; }

  /// Every g and rhs is kNever.
  void begin() {
    ++search_;
    heap_.clear();
  }

  bool touched(StateId id) const { return nodes_[id].search == search_; }
  std::uint64_t g(StateId id) const { return touched(id) ? nodes_[id].g : kNever; }
  std::uint64_t rhs(StateId id) const { return touched(id) ? nodes_[id].rhs : kNever; }

  void set_g(StateId id, std::uint64_t g) { touch(id).g = g; }
  void set_rhs(StateId id, std::uint64_t rhs) { touch(id).rhs = rhs; }

  /// Gives an inconsistent node its place in the heap, and takes a consistent one out.
  void update(StateId id, Key key) {
    Node& node = touch(id);
    if (node.place != kNoPlace) {
      heap_[node.place].key = key;
      settle(node.place);
      if (node.g == node.rhs) take_out(node.place);
    } else if (node.g != node.rhs) {
      node.place = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back({key, id});
      settle(node.place);
    }
  }

  bool empty() const { return heap_.empty(); }
  std::size_t open_count() const { return heap_.size(); }
  Key least_key() const { return heap_.front().key; }
  StateId least() const { return heap_.front().id; }

  /// The open nodes, ordered by key_of(id).
  template <class KeyOf>
  std::vector<StateId> in_order(KeyOf&& key_of) const {
    std::vector<Entry> entries = heap_;
    for (Entry& entry : entries) entry.key = key_of(entry.id);
    std::ranges::sort(entries);
    std::vector<StateId> ids;
    ids.reserve(entries.size());
    for (const Entry& entry : entries) ids.push_back(entry.id);
    return ids;
  }

 private:
  static constexpr std::uint32_t kNoPlace = ~std::uint32_t{0};

  struct Node {
    std::uint64_t g;
    std::uint64_t rhs;
    std::uint32_t place;   // in the heap
    std::uint32_t search;  // that touched it
  };
  struct Entry {
    Key key;
    StateId id;

    // Nodes with one key have an order of their own, the same on every platform.
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };

  Node& touch(StateId id) {
    Node& node = nodes_[id];
    if (node.search != search_) node = {kNever, kNever, kNoPlace, search_};
    return node;
  }

  void put(std::size_t place, const Entry& entry) {
    heap_[place] = entry;
    nodes_[entry.id].place = static_cast<std::uint32_t>(place);
  }

  /// Moves an entry to where its key belongs.
  void settle(std::size_t place) {
    const Entry entry = heap_[place];
    while (place > 0 && entry < heap_[(place - 1) / 2]) {
      put(place, heap_[(place - 1) / 2]);
      place = (place - 1) / 2;
    }
    for (;;) {
      std::size_t child = 2 * place + 1;
      if (child >= heap_.size()) break;
      if (child + 1 < heap_.size() && heap_[child + 1] < heap_[child]) ++child;
      if (entry < heap_[child]) break;
      put(place, heap_[child]);
      place = child;
    }
    put(place, entry);
  }

  void take_out(std::size_t place) {
    nodes_[heap_[place].id].place = kNoPlace;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (place == heap_.size()) return;
    put(place, last);
    settle(place);
  }

  ZeroedTable<Node> nodes_;
  std::uint32_t search_ = 0;
  std::vector<Entry> heap_;
};

}  // namespace wend
