#include "wend/planner/against_arrow.hpp"

#include <algorithm>
#include <deque>
#include <variant>

#include "wend/robot/directed_way.hpp"
#include "wend/space/grid/grid_space.hpp"

namespace wend {
namespace {

/// A search that goes first where no more steps lead against arrows.
class FewestAgainst {
 public:
  explicit FewestAgainst(const FreeSpace& space)
      : space_(space), grid_(space), known_(space.width(), space.height(), Known{}) {}

  /// The first arrow on the way; nothing if there is no way, or none against an arrow.
  std::optional<Cell> from(Cell start, Cell goal) {
    known_[start] = {0, start};
    open_.push_back(start);
    while (!open_.empty()) {
      const Cell cell = open_.front();
      open_.pop_front();
      if (known_[cell].closed) continue;
      known_[cell].closed = true;
      if (cell == goal) return first_arrow(goal);
      grid_.for_each_successor(grid_.state(cell), kNoMove,
                               [&](const GridState& next, Move, auto) { reach(next.cell, cell); });
    }
    return std::nullopt;
  }

 private:
  struct Known {
    int against = kUnknown;
    Cell parent = {};
    bool closed = false;
  };
  static constexpr int kUnknown = -1;

  void reach(Cell cell, Cell parent) {
    const bool along = may_step(space_, parent, cell);
    const int against = known_[parent].against + (along ? 0 : 1);
    Known& known = known_[cell];
    if (known.closed || (known.against != kUnknown && known.against <= against)) return;
    known.against = against;
    known.parent = parent;
    if (along) {
      open_.push_front(cell);
    } else {
      open_.push_back(cell);
    }
  }

  std::optional<Cell> first_arrow(Cell goal) const {
    std::optional<Cell> arrow;
    for (Cell cell = goal; !(known_[cell].parent == cell); cell = known_[cell].parent) {
      const Cell parent = known_[cell].parent;
      if (may_step(space_, parent, cell)) continue;
      const Direction direction = direction_of({cell.x - parent.x, cell.y - parent.y});
      const bool leaves =
          space_.directions()->factor(parent, direction) == DirectionMap::kForbidden;
      arrow = leaves ? parent : cell;
    }
    return arrow;
  }

  const FreeSpace& space_;
  ExactGrid grid_;
  Grid<Known> known_;
  std::deque<Cell> open_;
};

/// The goal of a cause that says that there is no path.
std::optional<std::size_t> goal_without_path(const FailureCause& cause) {
  if (const auto* const separated = std::get_if<Separated>(&cause)) return separated->goal;
  if (const auto* const motion = std::get_if<NoMotion>(&cause)) return motion->end.value_or(0);
  if (std::holds_alternative<NoDriveFound>(cause)) return 0;
  return std::nullopt;
}

}  // namespace

std::optional<Cell> first_arrow_against(const FreeSpace& space, Cell start, Cell goal) {
  if (space.directions() == nullptr || !space.passable(start) || !space.passable(goal)) return {};
  return FewestAgainst(space).from(start, goal);
}

void tell_arrows(const FreeSpace& space, Failure& failure) {
  if (space.directions() == nullptr || failure.status != Status::unreachable) return;
  const auto start = cell_under(space, failure.start.place);
  for (FailureCause& cause : failure.causes) {
    const auto goal = goal_without_path(cause);
    if (!start || !goal || *goal >= failure.goals.size()) continue;
    const auto end = cell_under(space, failure.goals[*goal].place);
    if (!end) continue;
    if (const auto arrow = first_arrow_against(space, *start, *end))
      cause = AgainstArrow{*goal, *arrow};
  }
}

}  // namespace wend
