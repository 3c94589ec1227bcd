#pragma once

// IndexSupport: how the index of a planner is built, and how a planner is made on it. Both are const
// and may be called by several threads.
//
//   const wend::PlannerInfo& info = *wend::planners().find("hub_labels");
//   const auto index = info.index_support->build(space, {});
//   if (!index) report(index.error().message);
//   const auto planner = info.index_support->make_planner(space, {}, *index);

#include "wend/base/options.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/index/index_building.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class IndexSupport {
 public:
  /// For derived classes.
  IndexSupport() = default;
  virtual ~IndexSupport() = default;
  IndexSupport(const IndexSupport&) = delete;
  IndexSupport& operator=(const IndexSupport&) = delete;

  /// What the planner needs to know of a map, to be kept.
  virtual Expected<IndexBytes, Error> build(const FreeSpace& space,
                                            const IndexBuilding& building) const = 0;

  /// A planner on an index, which it may share with others. An index of something else is
  /// index_mismatch.
  virtual PlannerResult make_planner(const FreeSpace& space, const OptionValues& options,
                                     IndexBytes index) const = 0;
};

}  // namespace wend
