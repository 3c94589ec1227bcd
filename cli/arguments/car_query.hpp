#pragma once

// CarQuery: a query of a car that drives from corner to corner, as it was typed.

#include <vector>

#include "cli/arguments/typed_pose.hpp"
#include "cli/arguments/typed_query.hpp"

namespace wend::cli {

class CarQuery final : public TypedQuery {
 public:
  CarQuery(FreeSpace space, const Coordinates& coordinates, int unit, const EndArguments& ends);

  void check(const ShownLayers& layers) const override;
  Query query() const override;
  std::vector<std::string> move_to_nearest() override;
  Scene scene() const override;
  /// Components and the widest path are of discs.
  Scene scene_of_failure(Status /*status*/) const override { return scene(); }
  std::optional<CostToGo> cost_to_go(const Limits& limits) const override;
  SearchRecorder recorder() const override;
  PosthocTrace trace(TraceForm form, std::uint64_t most_events) const override;
  std::string reason(const Planner& planner, Status status, const Limits& limits,
                     const SearchMetrics& metrics) const override;
  std::string steps(const Plan& plan, const Screen& screen) const override;
  std::string summary(const PlanResult& result) const override;

 private:
  std::string outside(const std::string& name, const TypedPose& pose) const;
  std::string as_typed() const;

  FreeSpace space_;
  Coordinates coordinates_;
  int unit_;  // of its lattice, in map cells
  TypedPose start_;
  std::vector<TypedPose> goals_;
};

}  // namespace wend::cli
