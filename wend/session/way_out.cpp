#include "wend/session/way_out.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/geometry/segment.hpp"
#include "wend/robot/sweep/overlap.hpp"

namespace wend {
namespace {

constexpr double kWayRounding = 1e-9;
constexpr double kWayStep = 0.05;  // cells, between two looks at the overlap

/// Is it a planner whose states have headings?
bool drives(const Planner& planner) { return !planner.grid_moves(); }

/// Does the planner accept a pose as a place of its own?
bool accepts(const Planner& planner, const Pose& pose) {
  return planner.nearest_free(Goal(pose)) == pose.point();
}

/// Dijkstra's search over cells. The overlap along each step decides about that step alone, so that what leads to a
/// cell does not matter to what leaves it.
class CellWay {
 public:
  CellWay(const FreeSpace& space, GridMoves moves, double most)
      : space_(space), moves_(moves), most_(most), measure_(space, true) {}

  std::optional<WayOut> from(Cell start) {
    open_.emplace(0, start.y, start.x);
    reached_[{start.y, start.x}] = {0, start};
    while (!open_.empty()) {
      const auto [length, y, x] = open_.top();
      open_.pop();
      const Cell cell{x, y};
      if (length > reached_.at({y, x}).length) continue;
      if (space_.passable(cell)) return way_to(cell, length);
      expand(cell, length);
    }
    return std::nullopt;
  }

 private:
  struct Reached {
    double length;
    Cell from;
  };

  void expand(Cell cell, double length) {
    const Overlap here = measure_.at(pose_at(cell));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const bool diagonal = dx != 0 && dy != 0;
        if ((dx == 0 && dy == 0) || (diagonal && moves_.connectivity == Connectivity::four)) {
          continue;
        }
        const Cell next{cell.x + dx, cell.y + dy};
        const double after = length + (diagonal ? std::numbers::sqrt2 : 1.0);
        if (!space_.contains(next) || after > most_ + kWayRounding) continue;
        if (diagonal && cuts_corner(cell, next, here)) continue;
        const auto known = reached_.find({next.y, next.x});
        if (known != reached_.end() && known->second.length <= after) continue;
        if (goes_deeper(cell, next, here)) continue;
        reached_[{next.y, next.x}] = {after, cell};
        open_.emplace(after, next.y, next.x);
      }
    }
  }

  /// Out of a zone, a diagonal step passes no corner of an obstacle.
  bool cuts_corner(Cell cell, Cell next, const Overlap& here) const {
    if (here.obstacles > space_.radius_in_cells()) return false;  // it is in one
    const auto is_obstacle = [&](Cell beside) {
      return space_.obstacles().blocked()[beside] && space_.map().zone(beside) == nullptr;
    };
    return is_obstacle({cell.x, next.y}) || is_obstacle({next.x, cell.y});
  }

  bool goes_deeper(Cell cell, Cell next, Overlap here) const {
    const Point from = centre_of(cell);
    const Point to = centre_of(next);
    constexpr int kLooks = 8;
    for (int i = 1; i <= kLooks; ++i) {
      const double share = static_cast<double>(i) / kLooks;
      const Overlap there =
          measure_.at({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), 0});
      if (there.exceeds(here)) return true;
      here = there;
    }
    return false;
  }

  WayOut way_to(Cell cell, double length) const {
    std::vector<Cell> cells{cell};
    for (;;) {
      const Cell before = reached_.at({cells.back().y, cells.back().x}).from;
      if (before == cells.back()) break;
      cells.push_back(before);
    }
    std::ranges::reverse(cells);
    return {Path(std::move(cells)), length};
  }

  const FreeSpace& space_;
  GridMoves moves_;
  double most_;
  OverlapMeasure measure_;
  using Entry = std::tuple<double, int, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::map<std::pair<int, int>, Reached> reached_;
};

/// The same over places and motions of a planner with headings.
class DrivenWay {
 public:
  DrivenWay(const Planner& planner, double most, int places)
      : planner_(planner),
        most_(most),
        places_(places),
        radius_(std::max(planner.free_space().radius_in_cells(), 0.1)),
        measure_(planner.free_space()) {}

  std::optional<WayOut> from(const Pose& start) {
    add({start, 0, 0, 0, {}});
    int expanded = 0;
    while (!open_.empty()) {
      const std::size_t index = open_.top().second;
      open_.pop();
      const Node node = nodes_[index];
      if (node.is_exit) return way_to(index);
      if (node.effort > best_[key_of(node.pose)] || ++expanded > places_) continue;
      if (index > 0 && accepts(planner_, node.pose) && measure_.at(node.pose).none()) {
        return way_to(index);
      }
      for (const LeavingMotion& motion : planner_.motions_from(node.pose, most_ - node.length)) {
        drive(index, node, motion);
      }
    }
    return std::nullopt;
  }

 private:
  struct Node {
    Pose pose;
    double effort;  // the length, and what turns in place move the farthest point of the robot by
    double length;  // cells
    std::size_t parent;       // itself for the first one
    std::vector<Pose> poses;  // of the motion from there, without its first
    bool is_exit = false;
  };

  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

  static Key key_of(const Pose& pose) {
    constexpr double kFine = 64;
    const double turn = std::remainder(pose.heading, 2 * kPi);
    return {std::llround(kFine * pose.x), std::llround(kFine * pose.y),
            std::llround(kFine * (turn < -kPi + 0.01 ? kPi : turn))};
  }

  void add(Node node) {
    if (!node.is_exit) {
      const auto [known, is_new] = best_.try_emplace(key_of(node.pose), node.effort);
      if (!is_new && known->second <= node.effort) return;
      known->second = node.effort;
    }
    open_.emplace(node.effort, nodes_.size());
    nodes_.push_back(std::move(node));
  }

  /// Follows a motion until the overlap grows, or to its end.
  void drive(std::size_t index, const Node& from, const LeavingMotion& motion) {
    Node next{from.pose, from.effort, from.length, index, {}};
    Overlap before = measure_.at(from.pose);
    for (const Segment& segment : motion.segments) {
      const double spin = segment.length == 0 ? radius_ * std::abs(segment.turn) : 0;
      const double whole = std::abs(segment.length) + spin;
      const int looks = std::max(1, static_cast<int>(std::ceil(whole / kWayStep)));
      for (int i = 1; i <= looks; ++i) {
        const double share = static_cast<double>(i) / looks;
        const double length = next.length + share * std::abs(segment.length);
        if (length > most_ + kWayRounding) return;
        const Pose pose = pose_on(segment, share);
        if (!cell_under(planner_.free_space(), pose.point())) return;
        const Overlap here = measure_.at(pose);
        if (here.exceeds(before)) return;
        before = here;
        if (motion.ends_anywhere && here.none() && is_in_free_cell(pose) &&
            accepts(planner_, pose)) {
          next.effort += share * whole;
          return add_exit(std::move(next), pose, length);
        }
      }
      next.effort += whole;
      next.length += std::abs(segment.length);
      next.poses.push_back(end_of(segment));
    }
    if (motion.ends_anywhere) return;
    next.pose = next.poses.back();
    add(std::move(next));
  }

  /// A point fits on the map's edge beside a blocked cell, from where nothing leads on.
  bool is_in_free_cell(const Pose& pose) const {
    const auto cell = cell_under(planner_.free_space(), pose.point());
    return cell && !planner_.free_space().obstacles().blocked()[*cell];
  }

  void add_exit(Node node, const Pose& pose, double length) {
    node.pose = pose;
    node.length = length;
    node.poses.push_back(pose);
    node.is_exit = true;
    add(std::move(node));
  }

  WayOut way_to(std::size_t index) const {
    const double length = nodes_[index].length;
    std::vector<Pose> poses;
    for (;;) {
      const Node& node = nodes_[index];
      poses.insert(poses.end(), node.poses.rbegin(), node.poses.rend());
      if (node.parent == index) break;
      index = node.parent;
    }
    poses.push_back(nodes_.front().pose);
    std::ranges::reverse(poses);
    return {Path::through(std::move(poses)), length};
  }

  const Planner& planner_;
  double most_;
  int places_;
  double radius_;
  OverlapMeasure measure_;
  std::vector<Node> nodes_;
  std::map<Key, double> best_;
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

bool is_blocked_start(const Planner& planner, const Pose& start) {
  const auto place = planner.place_of(start);
  if (!place) return false;
  if (drives(planner)) return !accepts(planner, *place);
  return !planner.free_space().passable(cell_at(place->point()));
}

std::optional<WayOut> way_out_over_cells(const FreeSpace& space, GridMoves moves, Cell start,
                                         double most) {
  return CellWay(space, moves, most).from(start);
}

std::optional<WayOut> way_out(const Planner& planner, const Pose& start, double most, int places) {
  const auto place = planner.place_of(start);
  if (!place || !(most > 0)) return std::nullopt;
  if (drives(planner)) return DrivenWay(planner, most, places).from(*place);
  const auto moves = planner.grid_moves();
  if (!moves) return std::nullopt;
  return way_out_over_cells(planner.free_space(), *moves, cell_at(place->point()), most);
}

}  // namespace wend
