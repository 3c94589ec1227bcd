// Answers many queries on all cores: the planner prepares once, and each worker has its own memory.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "wend/wend.hpp"

int main() {
  const auto map = wend::make_map("random", 200, 200, 7);
  if (!map) return std::puts(map.error().message.c_str()), 2;
  wend::Session session(*map);
  std::vector<wend::PlanRequest> requests(199);
  for (int y = 0; y < 199; ++y) requests[y] = {{1.5, y + 0.5, 0}, {{{198.5, 198.5 - y}}}};
  wend::ThreadWorkers workers;
  const auto answers = session.plan_all(requests, {"jps"}, workers);
  if (!answers) return std::puts(answers.error().message.c_str()), 2;
  const auto found = std::ranges::count_if(*answers, [](const auto& each) { return !!each; });
  std::printf("%td of %zu queries have a path\n", found, answers->size());
}
