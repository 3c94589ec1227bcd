#pragma once

// Planning: from a request in the map's frame to an answer that ROS clients understand. Knows no
// node; all threads may call it at once.

#include <wend_ros/PlanResult.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/planner/planner.hpp"
#include "wend_ros/map_snapshot.hpp"
#include "wend_ros/parameters.hpp"
#include "wend_ros/status_codes.hpp"

namespace wend_ros {

/// In the map's frame: metres, radians.
struct Ask {
  wend::Pose start;
  std::vector<wend::Pose> goals;
  bool any_heading = false;
  std::string planner;    // "astar:weight=2"; empty: the parameter's
  std::string options;    // "heuristic=euclidean"
  double time_limit = 0;  // s; 0: the parameter's
  bool from_field = false;
};

struct Watch {
  const std::atomic<bool>* cancel = nullptr;
  wend::SearchObserver* observer = nullptr;
};

/// A failure as an answer.
PlanResult refusal(StatusCode code, std::string reason);

class Planning {
 public:
  PlanResult answer(const MapSnapshot& map, const Parameters& parameters, const Ask& ask,
                    const Watch& watch = {});

 private:
  /// A planner that was made before, and what it was made for.
  struct Warm {
    std::uint64_t version;
    std::string spec;
    std::unique_ptr<wend::Planner> planner;
  };
  struct Field {
    std::uint64_t version;
    std::vector<wend::Cell> goals;
    wend::GridMoves moves;
    std::shared_ptr<const wend::CostToGo> costs;
  };

  std::unique_ptr<wend::Planner> take(std::uint64_t version, const std::string& spec);
  void give_back(Warm warm);
  PlanResult answer_from_field(const MapSnapshot& map, const Parameters& parameters,
                               const wend::Query& query, const wend::GridMoves& moves);
  std::shared_ptr<const wend::CostToGo> field_to(const MapSnapshot& map,
                                                 const std::vector<wend::Cell>& goals,
                                                 const wend::GridMoves& moves,
                                                 const wend::Limits& limits,
                                                 wend::PlanFailure& failure);

  std::mutex mutex_;
  std::vector<Warm> idle_;
  std::optional<Field> field_;
};

}  // namespace wend_ros
