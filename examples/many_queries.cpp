// Answers many queries on all cores: one clone of a planner for each worker.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::generators().find("random")->make(200, 200, 7, {});
  if (!map) return std::puts(map.error().message.c_str()), 2;
  const auto space = wend::make_free_space(*map).value();
  wend::ThreadWorkers workers;
  const auto first = wend::make_planner("jps", space).value();
  std::vector<std::unique_ptr<wend::Planner>> planners(workers.count());
  for (auto& planner : planners) planner = first->clone();
  std::vector<char> found(199);
  workers.run(found.size(), [&](std::size_t task, unsigned worker) {
    const int y = static_cast<int>(task);
    found[task] = planners[worker]->plan(wend::Query::between({1, y}, {198, 198 - y})).has_value();
  });
  std::printf("%td of %zu queries have a path\n", std::ranges::count(found, 1), found.size());
}
