#pragma once

// OMPL's Dubins and Reeds-Shepp lengths.

#include <memory>

#include "wend/geometry/pose.hpp"

namespace wend::bench {

class OmplCurves {
 public:
  /// The radius is 1.
  OmplCurves();
  ~OmplCurves();
  OmplCurves(const OmplCurves&) = delete;
  OmplCurves& operator=(const OmplCurves&) = delete;
  OmplCurves(OmplCurves&&) = delete;
  OmplCurves& operator=(OmplCurves&&) = delete;

  double dubins(const Pose& from, const Pose& to) const;
  double reeds_shepp(const Pose& from, const Pose& to) const;

 private:
  struct Spaces;
  std::unique_ptr<Spaces> spaces_;
};

}  // namespace wend::bench
