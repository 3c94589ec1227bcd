#include "wend/path/motion_tree.hpp"

#include <algorithm>
#include <cassert>

namespace wend {

void MotionTree::add(std::span<const Pose> branch) {
  poses_.insert(poses_.end(), branch.begin(), branch.end());
  ends_.push_back(poses_.size());
}

void MotionTree::clear() {
  poses_.clear();
  ends_.clear();
}

std::span<const Pose> MotionTree::branch(std::size_t i) const {
  assert(i < ends_.size());
  const std::size_t first = i == 0 ? 0 : ends_[i - 1];
  return std::span(poses_).subspan(first, ends_[i] - first);
}

MotionTree MotionTree::beginning(std::size_t count) const {
  MotionTree part;
  const std::size_t kept = std::min(count, ends_.size());
  if (kept == 0) return part;
  part.ends_.assign(ends_.begin(), ends_.begin() + static_cast<std::ptrdiff_t>(kept));
  part.poses_.assign(poses_.begin(),
                     poses_.begin() + static_cast<std::ptrdiff_t>(part.ends_.back()));
  return part;
}

}  // namespace wend
