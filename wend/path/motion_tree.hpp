#pragma once

// MotionTree: what a search over poses drove, expansion by expansion: each branch leads from a pose that was expanded
// before to the one that is expanded next.
//
//   const wend::MotionTree& tree = recorder.motions();
//   for (std::size_t i = 0; i < tree.size(); ++i) poses += tree.branch(i).size();
//
// 24 bytes a pose, 8 a branch.

#include <cstddef>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/geometry/pose.hpp"

namespace wend {

class WEND_API MotionTree {
 public:
  /// Adds the branch of the next expansion: poses in grid coordinates that segments join (geometry/segment.hpp), one
  /// for the start. O(poses) amortised.
  void add(std::span<const Pose> branch);
  /// Removes all branches.
  void clear();

  /// The number of branches, one for each expansion.
  std::size_t size() const { return ends_.size(); }
  /// Are there no branches?
  bool empty() const { return ends_.empty(); }
  /// The poses of the branch of expansion `i`, less than size(). Valid until the tree changes.
  std::span<const Pose> branch(std::size_t i) const;

  /// The first branches, `count` of them or all. O(their poses).
  MotionTree beginning(std::size_t count) const;

 private:
  std::vector<Pose> poses_;
  std::vector<std::size_t> ends_;  // in poses_, one for each branch
};

}  // namespace wend
