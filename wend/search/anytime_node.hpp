#pragma once

// AnytimeNode: a node of a search in rounds (AnytimeSearch). A state may be expanded once in each.

#include <cstdint>

namespace wend {

/// Adds to a MoveNode or ParentNode whether it is to be expanded, and the last round that expanded it.
template <class Base>
class AnytimeNode : public Base {
 public:
  /// For a state that is reached for the first time.
  void begin() { state_ = 0; }

  /// Is it to be expanded, in this round or later?
  bool is_open() const { return (state_ & kOpen) != 0; }
  void set_open(bool is) { state_ = is ? state_ | kOpen : state_ & ~kOpen; }

  bool expanded_in(std::uint32_t round) const { return state_ >> 1U == round; }
  void expand_in(std::uint32_t round) { state_ = round << 1U; }

 private:
  static constexpr std::uint32_t kOpen = 1;

  std::uint32_t state_;  // bit 0: open; then the round, 0 for none
};

}  // namespace wend
