#include "bench/scenario/scenario_queries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wend/analysis/cost_to_go.hpp"
#include "wend/base/random.hpp"

namespace wend {
namespace {

constexpr int kDecimals = 8;
constexpr std::size_t kRounds = 4;  // of as many searches as a bucket has queries

std::vector<Cell> passable_cells(const FreeSpace& space) {
  std::vector<Cell> cells;
  for (int y = 0; y < space.height(); ++y) {
    for (int x = 0; x < space.width(); ++x) {
      if (space.passable({x, y})) cells.push_back({x, y});
    }
  }
  return cells;
}

/// Rounded as in the file.
double rounded(double cost) {
  const double unit = std::pow(10, -kDecimals);
  return std::round(cost / unit) * unit;
}

class Buckets {
 public:
  explicit Buckets(const ScenarioPlan& plan) : plan_(plan), random_(plan.seed) {}

  Cell random_cell(const std::vector<Cell>& cells) { return cells[random_.below(cells.size())]; }

  /// Adds a query to every bucket that has room and that a path from `start` falls into.
  void add_from(Cell start, const CostToGo& field, const std::vector<Cell>& cells) {
    std::vector<Choice> choices;
    for (const Cell cell : cells) {
      const double cost = field.cost(cell);
      if (cell == start || !std::isfinite(cost)) continue;
      const std::size_t bucket = bucket_of(rounded(cost));
      if (bucket >= plan_.buckets || !has_room(bucket)) continue;
      if (choices.size() <= bucket) choices.resize(bucket + 1);
      Choice& choice = choices[bucket];
      if (random_.below(++choice.candidates) == 0) choice.cell = cell;
    }
    for (std::size_t bucket = 0; bucket < choices.size(); ++bucket) {
      if (choices[bucket].candidates == 0) continue;
      const Cell goal = choices[bucket].cell;
      add(bucket, start, goal, rounded(field.cost(goal)));
    }
  }

  bool full() const {
    return queries_.size() == plan_.buckets &&
           std::all_of(queries_.begin(), queries_.end(),
                       [this](const auto& queries) { return queries.size() == plan_.per_bucket; });
  }

  std::vector<ScenarioQuery> take(const FreeSpace& space) {
    std::vector<ScenarioQuery> all;
    for (std::vector<ScenarioQuery>& queries : queries_) {
      for (ScenarioQuery& query : queries) {
        query.map_width = space.width();
        query.map_height = space.height();
        all.push_back(std::move(query));
      }
    }
    return all;
  }

 private:
  struct Choice {
    std::uint64_t candidates = 0;
    Cell cell{};
  };

  static std::size_t bucket_of(double length) {
    return static_cast<std::size_t>(length / kBucketLength);
  }

  bool has_room(std::size_t bucket) const {
    return bucket >= queries_.size() || queries_[bucket].size() < plan_.per_bucket;
  }

  void add(std::size_t bucket, Cell start, Cell goal, double length) {
    if (queries_.size() <= bucket) queries_.resize(bucket + 1);
    std::vector<ScenarioQuery>& queries = queries_[bucket];
    const bool known = std::any_of(queries.begin(), queries.end(), [&](const auto& query) {
      return query.start == start && query.goal == goal;
    });
    if (known) return;
    ScenarioQuery query{};
    query.bucket = static_cast<int>(bucket);
    query.start = start;
    query.goal = goal;
    query.length = length;
    query.decimals = kDecimals;
    queries.push_back(std::move(query));
  }

  const ScenarioPlan& plan_;
  Random random_;
  std::vector<std::vector<ScenarioQuery>> queries_;
};

}  // namespace

Expected<std::vector<ScenarioQuery>, Status> scenario_queries(const FreeSpace& space,
                                                              GridMoves moves,
                                                              const ScenarioPlan& plan,
                                                              const Limits& limits) {
  const std::vector<Cell> cells = passable_cells(space);
  Buckets buckets(plan);
  if (cells.empty()) return buckets.take(space);
  for (std::size_t i = 0; i < kRounds * plan.per_bucket && !buckets.full(); ++i) {
    const Cell start = buckets.random_cell(cells);
    const auto field = CostToGo::make(space, std::array{start}, moves, limits);
    if (!field) return Unexpected<Status>(field.error().status);
    buckets.add_from(start, *field, cells);
  }
  return buckets.take(space);
}

}  // namespace wend
