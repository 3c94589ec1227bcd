// Builds an index of a map, saves it, opens it and answers a query with it.
#include <cstdio>

#include "wend/wend.hpp"

int main() {
  const auto loaded = wend::load_map("office.yaml");
  if (!loaded) return std::puts(loaded.error().message.c_str()), 2;
  const auto space =
      wend::make_free_space(loaded->map, {.footprint = wend::Footprint::disc(0.2)}).value();
  wend::ThreadWorkers workers;
  const wend::PlannerInfo& info = *wend::planners().find("hub_labels");
  const auto built = info.index_support->build(space, {.workers = &workers});
  if (!built) return std::puts(built.error().message.c_str()), 2;
  const auto saved = wend::write_index("office.idx", *built);
  if (!saved) return std::puts(saved.error().message.c_str()), 2;

  const auto index = wend::open_index("office.idx");
  if (!index) return std::puts(index.error().message.c_str()), 2;
  const auto planner = wend::make_planner("hub_labels", space, {}, *index);
  if (!planner) return std::puts(planner.error().message.c_str()), 2;
  const auto plan = (*planner)->plan(wend::Query::between({10, 10}, {150, 68}));
  if (!plan) return std::puts(plan.error().message.c_str()), 1;
  std::printf("cost %.4f, %zu cells\n", plan->cost, plan->path.size());
}
