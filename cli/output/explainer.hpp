#pragma once

// Why there is no plan: in words (which cell, why, how far, how large) and as a scene.

#include <optional>
#include <span>
#include <string>

#include "cli/arguments/coordinates.hpp"
#include "wend/analysis/no_path.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/planner/plan.hpp"
#include "wend/render/scene.hpp"
#include "wend/robot/free_space.hpp"

namespace wend::cli {

/// The start and the goals of a query.
struct Ends {
  Place start;
  Place goal;
};

class Explainer {
 public:
  /// All must outlive the explainer.
  Explainer(const FreeSpace& space, const Coordinates& coordinates, GridMoves moves)
      : space_(space), coordinates_(coordinates), moves_(moves) {}

  /// Why a query failed, in one or more sentences.
  std::string explain(Status status, const Ends& ends, const Limits& limits,
                      const SearchMetrics& metrics) const;

  /// "the start (3,4) lies outside the map, which covers ..."
  std::string outside(const Place& place) const;

  /// "the start (3,4) is blocked: it lies on an obstacle"
  std::string blocked(const Place& place) const;

  /// What would make a path: "unknown cells taken as free (--unknown free)".
  std::string change(const Way& way) const;

  /// The widest path, how wide and where it is narrowest: "a robot with a radius of up to 0.3 m".
  std::string width(const WidestPath& widest) const;

 private:
  std::string blocked_end(const Place& place, const Place& other) const;
  std::string nearest(const Place& place, const Place& other) const;
  std::string unreachable(const Ends& ends) const;
  std::string_view radius_name() const;
  std::string why(const Place& place, BlockReason reason) const;

  const FreeSpace& space_;
  const Coordinates& coordinates_;
  GridMoves moves_;
};

/// Did a search end at a limit, or because it was cancelled?
bool is_limit(Status status);

/// Why a search was stopped: "gave up after 1000 expansions, the limit".
std::string explain_limit(Status status, const Limits& limits, const SearchMetrics& metrics);

/// The nearest cell to a blocked one where the robot may stand; if it may stand at `other`, only cells
/// connected to that one count.
std::optional<Cell> nearest_free(const FreeSpace& space, Cell cell, Cell other, GridMoves moves);

/// The scene of a start and its goals, one or more; those outside the map are left out.
Scene no_path_scene(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                    GridMoves moves, const Coordinates& coordinates);

/// The same for one goal and a known reason. Start and goal must be on the map.
Scene no_path_scene(const FreeSpace& space, Cell start, Cell goal, GridMoves moves,
                    const Coordinates& coordinates, const NoPath& why);

/// What a path needs: "path for a robot of 0.45 m through unknown cells".
std::string describe(const Way& way, const Coordinates& coordinates);

}  // namespace wend::cli
