#include "bench/suites/se2/ompl_curves.hpp"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

namespace wend::bench {

namespace base = ompl::base;

struct OmplCurves::Spaces {
  std::shared_ptr<base::DubinsStateSpace> dubins = std::make_shared<base::DubinsStateSpace>(1);
  std::shared_ptr<base::ReedsSheppStateSpace> reeds_shepp =
      std::make_shared<base::ReedsSheppStateSpace>(1);
  base::ScopedState<base::SE2StateSpace> from{reeds_shepp};
  base::ScopedState<base::SE2StateSpace> to{reeds_shepp};

  void put(const Pose& begin, const Pose& end) {
    from->setXY(begin.x, begin.y);
    from->setYaw(begin.heading);
    to->setXY(end.x, end.y);
    to->setYaw(end.heading);
  }
};

OmplCurves::OmplCurves() : spaces_(std::make_unique<Spaces>()) {}
OmplCurves::~OmplCurves() = default;

double OmplCurves::dubins(const Pose& from, const Pose& to) const {
  spaces_->put(from, to);
  return spaces_->dubins->distance(spaces_->from.get(), spaces_->to.get());
}

double OmplCurves::reeds_shepp(const Pose& from, const Pose& to) const {
  spaces_->put(from, to);
  return spaces_->reeds_shepp->distance(spaces_->from.get(), spaces_->to.get());
}

}  // namespace wend::bench
