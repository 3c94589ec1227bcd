#include "wend/planner/se2/enclosure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "wend/geometry/angle.hpp"
#include "wend/planner/se2/pose_table.hpp"
#include "wend/robot/sweep/footprint_rows.hpp"
#include "wend/space/se2/motion.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostBoxes = 30'000;

/// The boxes around poses, of one size.
class BoxFlood {
 public:
  BoxFlood(const FreeSpace& space, double size)
      : space_(space),
        size_(size),
        headings_(
            static_cast<int>(std::clamp(2 * kPi * space.radius_in_cells() / size, 8.0, 4096.0))),
        seen_(size, headings_) {
    const double moved = size * std::numbers::sqrt2 / 2 + space.radius_in_cells() * kPi / headings_;
    const double share = 1 - moved / space.inscribed_radius_in_cells();
    if (share > 0) rows_ = FootprintRows(space.outline()->scaled(share));
  }

  bool encloses(const Pose& pose, const Pose& other, const std::function<bool()>& stop) {
    constexpr std::size_t kAtOnce = 256;
    if (rows_.empty() || !rows_.convex()) return false;
    add(box_of(pose));
    const Pose out = box_of(other);
    for (std::size_t next = 0; next < boxes_.size(); ++next) {
      if (boxes_.size() > kMostBoxes || (next % kAtOnce == 0 && stop())) return false;
      const Pose box = boxes_[next];
      for (const int by : {-1, 1}) {
        add(box_of({box.x + by * size_, box.y, box.heading}));
        add(box_of({box.x, box.y + by * size_, box.heading}));
        add(box_of({box.x, box.y, box.heading + by * 2 * kPi / headings_}));
      }
    }
    return seen_[out] == PoseTable::kNone;
  }

 private:
  /// The middle of the box of a pose.
  Pose box_of(const Pose& pose) const {
    const double turn = 2 * kPi / headings_;
    return {(std::floor(pose.x / size_) + 0.5) * size_, (std::floor(pose.y / size_) + 0.5) * size_,
            wrapped_angle(std::round(pose.heading / turn) * turn)};
  }

  void add(const Pose& box) {
    std::uint32_t& seen = seen_[box];
    if (seen != PoseTable::kNone) return;
    if (!boxes_.empty() && rows_.meet_obstacle(space_, box, 0)) return;
    seen = static_cast<std::uint32_t>(boxes_.size());
    boxes_.push_back(box);
  }

  const FreeSpace& space_;
  double size_;
  int headings_;
  PoseTable seen_;
  FootprintRows rows_;
  std::vector<Pose> boxes_;
};

}  // namespace

bool is_enclosed(const FreeSpace& space, const Pose& pose, const Pose& other,
                 const std::function<bool()>& stop) {
  if (space.outline() == nullptr) return false;
  constexpr std::array kSizes{1.0, 0.125};  // cells
  return std::ranges::any_of(
      kSizes, [&](double size) { return BoxFlood(space, size).encloses(pose, other, stop); });
}

}  // namespace wend
