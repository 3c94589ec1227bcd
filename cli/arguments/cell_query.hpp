#pragma once

// CellQuery: a query of a robot that moves from cell to cell, as it was typed.

#include <vector>

#include "cli/arguments/typed_query.hpp"
#include "cli/output/explainer.hpp"

namespace wend::cli {

class CellQuery final : public TypedQuery {
 public:
  CellQuery(FreeSpace space, const Coordinates& coordinates, GridMoves moves,
            const EndArguments& ends);

  void check(const ShownLayers& /*layers*/) const override {}
  Query query() const override;
  std::vector<std::string> move_to_nearest() override;
  Scene scene() const override;
  Scene scene_of_failure(Status status) const override;
  std::optional<CostToGo> cost_to_go(const Limits& limits) const override;
  SearchRecorder recorder() const override;
  PosthocTrace trace(TraceForm form, std::uint64_t most_events) const override;
  std::string reason(const Planner& planner, Status status, const Limits& limits,
                     const SearchMetrics& metrics) const override;
  std::string steps(const Plan& plan, const Screen& screen) const override;
  std::string summary(const PlanResult& result) const override;

 private:
  std::vector<Cell> goal_cells() const;

  FreeSpace space_;
  Coordinates coordinates_;
  GridMoves moves_;
  Place start_;
  std::vector<Place> goals_;
};

}  // namespace wend::cli
