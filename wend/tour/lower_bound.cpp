#include "wend/tour/lower_bound.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace wend {
namespace {

constexpr int kLargestExponent =
    36;  // of a cost: sums of 2^12 of them and their weights are exact doubles
constexpr int kSparseDegree = 8;       // edges of a place that most trees are made of
constexpr double kLeastCost = 1e-150;  // of the largest one: else its fractions are no numbers
constexpr int kTrees = 80;
constexpr int kPatience = 8;  // trees without progress until steps are halved

/// An edge of the sparse graph.
struct Edge {
  int to;
  double cost;
};

/// A 1-tree: the degrees of its places and what it costs, weights included.
struct OneTree {
  double cost = 0;
  std::vector<int> degrees;
  std::vector<int> parents;  // of the spanning tree
};

/// All numbers are whole.
class OneTrees {
 public:
  OneTrees(const OrderProblem& problem, double unit)
      : places_(problem.places()), weights_(static_cast<std::size_t>(places_), 0.0) {
    const std::vector<double> slope = slopes(problem.costs, unit);
    costs_.reserve(static_cast<std::size_t>(places_) * static_cast<std::size_t>(places_));
    const double tie = std::ldexp(-1.0, kLargestExponent + 1);
    for (int a = 0; a < places_; ++a) {
      for (int b = 0; b < places_; ++b) {
        const double rise = slope[index(b)] - slope[index(a)];
        const double there = std::floor(problem.costs(a, b) / unit) - rise;
        const double back = std::floor(problem.costs(b, a) / unit) + rise;
        const bool tied = problem.tied(a, b);
        costs_.push_back(std::min(there, back) + (tied ? tie : 0));
        if (tied && a < b) allowance_ -= tie;
      }
    }
  }

  /// The tree over all edges. O(places^2).
  OneTree full() const {
    OneTree tree = empty_tree();
    const auto count = static_cast<std::size_t>(places_);
    std::vector<double> least(count, std::numeric_limits<double>::infinity());
    std::vector<char> inside(count, 0);
    int at = 1;
    for (int joined = 1; joined < places_ - 1; ++joined) {
      inside[index(at)] = 1;
      int nearest = 0;
      for (int place = 1; place < places_; ++place) {
        if (inside[index(place)] != 0) continue;
        const double cost = weighted(at, place);
        if (cost < least[index(place)]) {
          least[index(place)] = cost;
          tree.parents[index(place)] = at;
        }
        if (nearest == 0 || least[index(place)] < least[index(nearest)]) nearest = place;
      }
      join(tree, nearest, tree.parents[index(nearest)], least[index(nearest)]);
      at = nearest;
    }
    std::vector<std::pair<double, int>> ends;
    for (int place = 1; place < places_; ++place) ends.emplace_back(weighted(0, place), place);
    close(tree, ends);
    return tree;
  }

  /// Most trees are made of these edges: to the nearest places, and of a tree.
  void keep_edges_of(const OneTree& tree) {
    if (near_.empty()) list_nearest();
    for (int place = 1; place < places_; ++place) {
      const int parent = tree.parents[index(place)];
      if (parent > 0) add_edge(place, parent);
    }
  }

  /// The tree over the edges that are kept; they are connected.
  OneTree sparse() const {
    OneTree tree = empty_tree();
    using Open = std::tuple<double, int, int>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    std::vector<char> inside(static_cast<std::size_t>(places_), 0);
    const auto enter = [&](int place) {
      inside[index(place)] = 1;
      for (const Edge& edge : near_[index(place)]) {
        if (edge.to == 0 || inside[index(edge.to)] != 0) continue;
        open.emplace(edge.cost + weights_[index(place)] + weights_[index(edge.to)], edge.to, place);
      }
    };
    enter(1);
    while (!open.empty()) {
      const auto [cost, place, parent] = open.top();
      open.pop();
      if (inside[index(place)] != 0) continue;
      tree.parents[index(place)] = parent;
      join(tree, place, parent, cost);
      enter(place);
    }
    std::vector<std::pair<double, int>> ends;
    for (const Edge& edge : near_.front()) {
      ends.emplace_back(edge.cost + weights_.front() + weights_[index(edge.to)], edge.to);
    }
    close(tree, ends);
    return tree;
  }

  /// What a tree says of tours: its cost without the weights that every tour pays.
  double bound(const OneTree& tree) const {
    double paid = 0;
    for (const double weight : weights_) paid += weight;
    return tree.cost - 2 * paid + allowance_;
  }

  /// Makes places dearer that have more than two edges. Weights stay whole and small enough for exact sums.
  void move_weights(const OneTree& tree, const OneTree& last, double step) {
    const double most = std::ldexp(1.0, kLargestExponent);
    for (std::size_t place = 0; place < weights_.size(); ++place) {
      const double pull = 0.7 * (tree.degrees[place] - 2) + 0.3 * (last.degrees[place] - 2);
      weights_[place] = std::clamp(weights_[place] + std::round(step * pull), -most, most);
    }
  }

  const std::vector<double>& weights() const { return weights_; }
  void set_weights(std::vector<double> weights) { weights_ = std::move(weights); }

 private:
  static std::size_t index(int place) { return static_cast<std::size_t>(place); }

  double cost(int a, int b) const {
    return costs_[index(a) * static_cast<std::size_t>(places_) + index(b)];
  }
  double weighted(int a, int b) const {
    return cost(a, b) + weights_[index(a)] + weights_[index(b)];
  }

  /// Half of what ways to each place cost more than those from there, on average, in whole units.
  static std::vector<double> slopes(const CostMatrix& costs, double unit) {
    std::vector<double> slope;
    for (int place = 0; place < costs.size(); ++place) {
      double difference = 0;
      int counted = 0;
      for (int other = 0; other < costs.size(); ++other) {
        const double there = costs(other, place);
        const double back = costs(place, other);
        if (!(there < CostMatrix::kNoWay) || !(back < CostMatrix::kNoWay)) continue;
        difference += there / unit - back / unit;
        ++counted;
      }
      slope.push_back(counted == 0 ? 0 : std::round(difference / (2.0 * counted)));
    }
    return slope;
  }

  OneTree empty_tree() const {
    const auto count = static_cast<std::size_t>(places_);
    return {0, std::vector<int>(count, 0), std::vector<int>(count, OrderProblem::kNone)};
  }

  static void join(OneTree& tree, int a, int b, double cost) {
    ++tree.degrees[index(a)];
    ++tree.degrees[index(b)];
    tree.cost += cost;
  }

  /// Joins place 0 to the two nearest.
  static void close(OneTree& tree, std::vector<std::pair<double, int>>& ends) {
    std::ranges::partial_sort(ends, ends.begin() + 2);
    for (std::size_t i = 0; i < 2; ++i) join(tree, 0, ends[i].second, ends[i].first);
  }

  void list_nearest() {
    near_.resize(static_cast<std::size_t>(places_));
    std::vector<int> others;
    for (int place = 0; place < places_; ++place) {
      others.clear();
      for (int other = 0; other < places_; ++other) {
        if (other != place) others.push_back(other);
      }
      const auto kept =
          std::min(static_cast<std::ptrdiff_t>(others.size()), std::ptrdiff_t{kSparseDegree});
      std::ranges::partial_sort(others, others.begin() + kept, [&](int a, int b) {
        return std::pair(cost(place, a), a) < std::pair(cost(place, b), b);
      });
      for (std::ptrdiff_t i = 0; i < kept; ++i)
        add_edge(place, others[static_cast<std::size_t>(i)]);
    }
  }

  void add_edge(int a, int b) {
    const auto has = [&](int from, int to) {
      return std::ranges::any_of(near_[index(from)],
                                 [to](const Edge& edge) { return edge.to == to; });
    };
    if (!has(a, b)) near_[index(a)].push_back({b, cost(a, b)});
    if (!has(b, a)) near_[index(b)].push_back({a, cost(a, b)});
  }

  int places_;
  std::vector<double> costs_;
  std::vector<double> weights_;
  std::vector<std::vector<Edge>> near_;
  double allowance_ = 0;  // what ties were made cheaper by
};

/// Moves the weights until the bound of sparse trees hardly grows; leaves the best weights.
void ascend(OneTrees& trees, double target, const Deadline& deadline) {
  OneTree last = trees.sparse();
  double best = trees.bound(last);
  std::vector<double> weights = trees.weights();
  double share = 1;
  int idle = 0;
  OneTree tree = last;
  for (int i = 0; i < kTrees && !deadline.passed(); ++i) {
    double squares = 0;
    for (const int degree : tree.degrees) squares += (degree - 2) * (degree - 2);
    if (squares == 0) break;  // the tree is a tour
    trees.move_weights(tree, last, share * std::max(1.0, target - trees.bound(tree)) / squares);
    last = std::move(tree);
    tree = trees.sparse();
    if (trees.bound(tree) > best) {
      best = trees.bound(tree);
      weights = trees.weights();
      idle = 0;
    } else if (++idle == kPatience) {
      share /= 2;
      idle = 0;
    }
  }
  trees.set_weights(std::move(weights));
}

}  // namespace

double lower_bound(const OrderProblem& problem, double cost, const Deadline& deadline) {
  double largest = 0;
  for (const double way : problem.costs.values()) {
    if (way < CostMatrix::kNoWay) largest = std::max(largest, way);
  }
  if (largest < kLeastCost) return 0;
  const double unit = std::ldexp(1.0, std::ilogb(largest) + 1 - kLargestExponent);
  OneTrees trees(problem, unit);
  double best = 0;
  const OneTree first = trees.full();
  best = std::max(best, trees.bound(first));
  trees.keep_edges_of(first);
  for (int round = 0; round < 2 && !deadline.passed(); ++round) {
    ascend(trees, cost / unit, deadline);
    const OneTree tree = trees.full();
    best = std::max(best, trees.bound(tree));
    trees.keep_edges_of(tree);
  }
  return std::min(best * unit, cost);
}

}  // namespace wend
