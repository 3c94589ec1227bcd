#pragma once

// FrontierEntry: an open state in a frontier that orders states by key.

#include <cstdint>

#include "wend/base/state_id.hpp"

namespace wend {

/// Entries are totally ordered: the smaller key first, and of equal keys the one that was pushed
/// last. So the order of expansion does not depend on how a frontier works inside.
template <class OrderedKey>
struct FrontierEntry {
  OrderedKey key;
  std::uint32_t age_rank;  // falls with every push
  StateId id;

  friend bool operator<(const FrontierEntry& a, const FrontierEntry& b) {
    if (a.key < b.key) return true;
    if (b.key < a.key) return false;
    return a.age_rank < b.age_rank;
  }
};

}  // namespace wend
