// The shortest path at any angle, looked up in labels of corners. J. Du, B. Shen and M. A. Cheema, "Ultrafast Euclidean
// Shortest Path Computation Using Hub Labeling", 2023.

#include <limits>
#include <span>
#include <utility>

#include "wend/index/euclidean_labels/euclidean_index.hpp"
#include "wend/planner/any_angle/taut_path.hpp"
#include "wend/planner/indexed/index_planner.hpp"
#include "wend/planner/plan.hpp"

namespace wend {
namespace {

class EuclideanAnswers final : public IndexAnswers {
 public:
  EuclideanAnswers(std::unique_ptr<EuclideanEngine> engine, FreeSpace space)
      : engine_(std::move(engine)), space_(std::move(space)) {}

  double find(Cell start, Cell goal) override {
    start_ = start;
    goal_ = goal;
    is_found_ = engine_->find(start, goal);
    return is_found_ ? engine_->length() : std::numeric_limits<double>::infinity();
  }

  std::optional<double> write(Path& path) override {
    if (!is_found_) return std::nullopt;
    const std::span<const std::uint32_t> corners = engine_->corners();
    Point last = centre_of(start_);
    path.go_to(last);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point here = vertex(corners[i]);
      const Point next = i + 1 < corners.size() ? vertex(corners[i + 1]) : centre_of(goal_);
      if (goes_straight_on(last, here, next)) continue;
      path.go_to(here);
      last = here;
    }
    path.go_to(centre_of(goal_));
    if (!space_.is_point() && !disc_fits_along_path(space_, path, kAdjacency) &&
        !write_pulled_trail(space_, kAdjacency, engine_->portals(), start_, corners, goal_, path)) {
      return std::nullopt;
    }
    return path.length();
  }

  void write_place(Cell cell, Path& path) const override { path.go_to(centre_of(cell)); }
  /// The robot's own disc decides how near it may come; only a point's shortest path is known.
  double bound() const override { return space_.is_point() ? 1 : Plan::kNoBound; }
  SearchMetrics metrics() const override { return engine_->metrics(); }

 private:
  static constexpr Adjacency kAdjacency = Adjacency::edges;

  Point vertex(std::uint32_t id) const {
    const TautCorner& corner = engine_->portals().corners()[id];
    return {static_cast<double>(corner.x), static_cast<double>(corner.y)};
  }

  std::unique_ptr<EuclideanEngine> engine_;
  FreeSpace space_;
  Cell start_;
  Cell goal_;
  bool is_found_ = false;
};

Expected<std::unique_ptr<IndexAnswers>, Error> open_answers(IndexBytes index,
                                                            const FreeSpace& space) {
  auto engine = EuclideanEngine::open(std::move(index), space.passable());
  if (!engine) return Unexpected<Error>(engine.error());
  return std::make_unique<EuclideanAnswers>(*std::move(engine), space);
}

}  // namespace

PlannerInfo euclidean_labels_planner() {
  return with_index(
      {.name = std::string(kEuclideanLabels),
       .summary = "Looks up the shortest path at any angle",
       .idea =
           "A shortest path turns at corners of obstacles, and is taut there. Each corner has a "
           "label: a few hubs with the lengths of the taut paths to them, sorted by the edge by "
           "which they begin. A cell looks up the corners that it sees, and of their labels the "
           "part that goes on taut. The path leads through the best common hub.",
       .citation = "Du, Shen, Cheema 2023; Akiba, Iwata, Yoshida 2013",
       .guarantee_text =
           "optimal for a point on uniform terrain: no path at any angle is shorter; for a disc or "
           "a polygon complete, and every path is free",
       .time = "O(corners seen from start and goal + their entries that go on taut), about a "
               "microsecond",
       .memory = "index: 16 bytes per entry of a label and per corner and block of 8 x 8 cells "
                 "that sees it; planner: 24 bytes per corner, 16 per run of free cells in a row, "
                 "24 per opening between two of them",
       .when = "For many queries at any angle on one map. Building the index takes less than a "
               "second on most maps. A map with more than 65536 corners, or whose corners see too "
               "much, gets no index, and the error names the limit: any_angle plans there. An edit "
               "needs a new index: any_angle does not.",
       .guarantee = Guarantee::complete,
       .preprocessing = Preprocessing::quick,
       .capabilities = {.any_angle = true}},
      {.build = build_euclidean_index, .open = open_answers});
}

}  // namespace wend
