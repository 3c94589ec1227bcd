// ForwardSearch on explicit graphs: what it finds, counts and reports, and when it stops.

#include "wend/search/forward_search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "wend/base/random.hpp"
#include "wend/search/frontiers.hpp"
#include "wend/search/paged_nodes.hpp"

namespace wend {
namespace {

using ::testing::ElementsAre;

/// A graph as a list of edges. The n-th edge into a state is its move n.
class Graph {
 public:
  using State = StateId;
  using Cost = int;

  explicit Graph(StateId count) : edges_(count), sources_(count) {}

  void add(StateId from, StateId to, int cost) {
    if (sources_[to].size() == kNoMove) return;  // no move numbers left
    edges_[from].push_back({to, static_cast<Move>(sources_[to].size()), cost});
    sources_[to].push_back(from);
  }

  StateId state_count() const { return static_cast<StateId>(edges_.size()); }
  State state(StateId id) const { return id; }
  StateId id(State state) const { return state; }
  State parent(State state, Move move) const { return sources_[state][move]; }

  template <class Sink>
  void for_each_successor(State state, Move /*arrival*/, Sink&& sink) const {
    for (const Edge& edge : edges_[state]) sink(edge.to, edge.move, edge.cost);
  }

  /// The cheapest cost from any start to every state (Bellman and Ford).
  std::vector<int> costs_from(const std::vector<StateId>& starts, bool count_edges) const {
    std::vector<int> costs(edges_.size(), kUnreached);
    for (const StateId start : starts) costs[start] = 0;
    for (std::size_t round = 0; round < edges_.size(); ++round) {
      for (StateId from = 0; from < state_count(); ++from) {
        for (const Edge& edge : edges_[from]) {
          if (costs[from] == kUnreached) continue;
          const int cost = costs[from] + (count_edges ? 1 : edge.cost);
          costs[edge.to] = std::min(costs[edge.to], cost);
        }
      }
    }
    return costs;
  }

  static constexpr int kUnreached = std::numeric_limits<int>::max();

 private:
  struct Edge {
    StateId to;
    Move move;
    int cost;
  };
  std::vector<std::vector<Edge>> edges_;
  std::vector<std::vector<StateId>> sources_;
};

Graph row_of(StateId count) {
  Graph graph(count);
  for (StateId state = 0; state + 1 < count; ++state) graph.add(state, state + 1, 1);
  return graph;
}

Graph random_graph(Random& random) {
  Graph graph(static_cast<StateId>(random.between(1, 30)));
  for (int edges = random.between(0, 90); edges > 0; --edges) {
    graph.add(static_cast<StateId>(random.below(graph.state_count())),
              static_cast<StateId>(random.below(graph.state_count())), random.between(0, 9));
  }
  return graph;
}

constexpr StateId kNowhere = 1'000'000;

struct CheapestFirst {
  using Key = int;
  int key(StateId /*state*/, int g) const { return g; }
  bool is_goal(StateId state) const { return state == goal; }
  bool near_overflow(int key) const { return key >= most; }

  StateId goal = kNowhere;
  int most = std::numeric_limits<int>::max();
};

struct InOrder {
  using Key = NoKey;
  NoKey key(StateId /*state*/, int /*g*/) const { return {}; }
  bool is_goal(StateId state) const { return state == goal; }
  bool near_overflow(NoKey /*key*/) const { return false; }

  StateId goal = kNowhere;
};

using Dijkstra =
    ForwardSearch<Graph, HeapFrontier<int>, CheapestFirst, DuplicateRule::keep_cheaper>;
using BreadthFirst = ForwardSearch<Graph, FifoFrontier, InOrder, DuplicateRule::keep_first>;

using DijkstraByParents = ForwardSearch<Graph, HeapFrontier<int>, CheapestFirst,
                                        DuplicateRule::keep_cheaper, ParentLinks>;
template <class Links, template <class> class Store>
using DijkstraIn = ForwardSearch<Graph, HeapFrontier<int>, CheapestFirst,
                                 DuplicateRule::keep_cheaper, Links, Store>;

/// Records each event: "g" generated, "e" expanded, "r" relaxed, with state and cost.
struct Diary {
  void on_generate(StateId state, Move, int g) { note("g", state, g); }
  void on_expand(StateId state, Move, int g) { note("e", state, g); }
  void on_relax(StateId state, Move, int g) { note("r", state, g); }
  void note(const std::string& what, StateId state, int g) {
    events.push_back(what + std::to_string(state) + ":" + std::to_string(g));
  }

  std::vector<std::string> events;
};

template <class Search>
std::vector<StateId> path_of(const Search& search) {
  std::vector<StateId> path;
  search.for_each_back_from(search.goal(), [&](StateId state) { path.push_back(state); });
  return {path.rbegin(), path.rend()};
}

template <class Search>
SearchOutcome search_from(Search& search, const std::vector<StateId>& starts,
                          const Limits& limits = {}) {
  search.begin(starts, limits);
  return search.run();
}

TEST(ForwardSearch, FindsTheCheapestCostsOnRandomGraphs) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Graph graph = random_graph(random);
    Dijkstra dijkstra(graph, CheapestFirst{});
    BreadthFirst breadth_first(graph, InOrder{});
    for (int reuse = 0; reuse < 5; ++reuse) {
      std::vector<StateId> starts;
      for (int i = random.between(1, 3); i > 0; --i) {
        starts.push_back(static_cast<StateId>(random.below(graph.state_count())));
      }
      ASSERT_EQ(search_from(dijkstra, starts), SearchOutcome::exhausted);
      ASSERT_EQ(search_from(breadth_first, starts), SearchOutcome::exhausted);
      const auto costs = graph.costs_from(starts, false);
      const auto edges = graph.costs_from(starts, true);
      std::uint64_t reachable = 0;
      for (StateId id = 0; id < graph.state_count(); ++id) {
        const bool reached = costs[id] != Graph::kUnreached;
        ASSERT_EQ(dijkstra.closed(id), reached);
        ASSERT_EQ(breadth_first.closed(id), reached);
        if (!reached) continue;
        ++reachable;
        EXPECT_EQ(dijkstra.g(id), costs[id]);
        int steps = -1;
        breadth_first.for_each_back_from(id, [&](StateId) { ++steps; });
        EXPECT_EQ(steps, edges[id]);
      }
      EXPECT_EQ(dijkstra.metrics().expanded, reachable);
      EXPECT_EQ(dijkstra.metrics().generated, reachable);
      EXPECT_EQ(breadth_first.metrics().expanded, reachable);
    }
  }
}

/// Holds another search to Dijkstra's algorithm by moves, query after query on random graphs.
template <class Search>
void expands_as_dijkstra_does() {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Graph graph = random_graph(random);
    const auto goal = static_cast<StateId>(random.below(graph.state_count()));
    Dijkstra dijkstra(graph, CheapestFirst{goal});
    Search search(graph, CheapestFirst{goal});
    for (int reuse = 0; reuse < 3; ++reuse) {
      const auto start = static_cast<StateId>(random.below(graph.state_count()));
      ASSERT_EQ(search_from(search, {start}), search_from(dijkstra, {start}));
      EXPECT_EQ(search.metrics(), dijkstra.metrics());
      for (StateId id = 0; id < graph.state_count(); ++id) {
        ASSERT_EQ(search.closed(id), dijkstra.closed(id));
        if (!dijkstra.closed(id)) continue;
        EXPECT_EQ(search.g(id), dijkstra.g(id));
      }
      if (dijkstra.outcome() != SearchOutcome::found) continue;
      EXPECT_EQ(path_of(search), path_of(dijkstra));
    }
  }
}

TEST(ForwardSearch, WithParentsInItsNodesExpandsTheSameStates) {
  expands_as_dijkstra_does<DijkstraByParents>();
}

TEST(ForwardSearch, WithOtherStoresExpandsTheSameStates) {
  expands_as_dijkstra_does<DijkstraIn<StepLinks, PagedNodes>>();
  expands_as_dijkstra_does<DijkstraIn<ParentLinks, PagedNodes>>();
}

/// More than they have room for at first.
template <template <class> class Store>
void reaches_many_states() {
  constexpr StateId kStates = 100000;
  DijkstraIn<StepLinks, Store> search(row_of(kStates), CheapestFirst{kStates - 1});
  for (int reuse = 0; reuse < 2; ++reuse) {
    ASSERT_EQ(search_from(search, {0}), SearchOutcome::found);
    EXPECT_EQ(search.g(kStates - 1), int{kStates - 1});
    EXPECT_EQ(path_of(search).size(), kStates);
  }
}

TEST(ForwardSearch, WithPagedNodesReachesManyStates) { reaches_many_states<PagedNodes>(); }

/// A store without memory for more than ten states.
template <class Node>
class TenNodes : public NodeTable<Node> {
 public:
  static constexpr bool kGrows = true;

  using NodeTable<Node>::NodeTable;
  Node* room_for(StateId id) { return id < 10 ? NodeTable<Node>::room_for(id) : nullptr; }
};

TEST(ForwardSearch, EndsWhenItsStoreHasNoMemoryLeft) {
  DijkstraIn<StepLinks, TenNodes> search(row_of(1000), CheapestFirst{999});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::out_of_memory);
  EXPECT_EQ(search.metrics().expanded, 10U);
  DijkstraIn<StepLinks, TenNodes> small(row_of(1000), CheapestFirst{9});
  EXPECT_EQ(search_from(small, {0}), SearchOutcome::found);
}

/// A detour that is cheaper, a dead end, and a state beyond the goal.
Graph detour() {
  Graph graph(6);
  graph.add(0, 1, 10);
  graph.add(0, 2, 1);
  graph.add(2, 1, 2);
  graph.add(2, 5, 1);
  graph.add(1, 3, 1);
  graph.add(3, 4, 1);
  return graph;
}

/// Lets a state that is about to be expanded go back to its start, at a cost of 100.
struct BackToTheStart : ParentLinks {
  static std::optional<Link<int>> settled(const auto& /*search*/, StateId state) {
    return state == 1 ? std::optional(Link<int>{0, 100}) : std::nullopt;
  }
};

TEST(ForwardSearch, ExpandsAStateByTheLinkThatItSettledOn) {
  ForwardSearch<Graph, HeapFrontier<int>, CheapestFirst, DuplicateRule::keep_cheaper,
                BackToTheStart>
      search(detour(), CheapestFirst{3});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::found);
  EXPECT_THAT(path_of(search), ElementsAre(0, 1, 3));
  EXPECT_EQ(search.g(3), 101);
}

TEST(ForwardSearch, TellsEveryEventInOrder) {
  Dijkstra search(detour(), CheapestFirst{3});
  Diary diary;
  const std::array<StateId, 1> starts{0};
  const Limits limits;
  search.begin(starts, limits, diary);
  EXPECT_EQ(search.run(diary), SearchOutcome::found);
  EXPECT_THAT(diary.events, ElementsAre("g0:0", "e0:0", "g1:10", "g2:1", "e2:1", "r1:3", "g5:2",
                                        "e5:2", "e1:3", "g3:4", "e3:4"));
  EXPECT_EQ(search.goal(), 3U);
  EXPECT_THAT(path_of(search), ElementsAre(0, 2, 1, 3));
  EXPECT_FALSE(search.reached(4)) << "the goal is not expanded further";
}

TEST(ForwardSearch, KeepsTheFirstWhenToldTo) {
  BreadthFirst search(detour(), InOrder{3});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::found);
  EXPECT_THAT(path_of(search), ElementsAre(0, 1, 3));
  EXPECT_EQ(search.g(3), 11);
}

TEST(ForwardSearch, CountsTheGoalAsExpanded) {
  Dijkstra search(detour(), CheapestFirst{3});
  search_from(search, {0});
  // Generated 0, 1, 2, 5, 3; expanded 0, 2, 5, 1, 3; at most 1 and 5 were open at once.
  EXPECT_EQ(search.metrics(), (SearchMetrics{5, 5, 2}));
}

TEST(ForwardSearch, AStartThatIsTheGoalIsExpandedAndNothingElse) {
  Dijkstra search(detour(), CheapestFirst{0});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::found);
  EXPECT_EQ(search.metrics(), (SearchMetrics{1, 1, 1}));
  EXPECT_THAT(path_of(search), ElementsAre(0));
}

TEST(ForwardSearch, NeverOpensAClosedStateAgain) {
  // An inconsistent estimate: state 1 is expanded with 10 before its cheaper path is known.
  struct Misled : CheapestFirst {
    int key(StateId state, int g) const { return state == 2 ? g + 100 : g; }
  };
  ForwardSearch<Graph, HeapFrontier<int>, Misled, DuplicateRule::keep_cheaper> search(detour(),
                                                                                      Misled{});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::exhausted);
  EXPECT_EQ(search.g(1), 10);
  EXPECT_EQ(search.metrics().expanded, 6U);
}

TEST(ForwardSearch, StartsFromSeveralStates) {
  Dijkstra search(row_of(10), CheapestFirst{9});
  EXPECT_EQ(search_from(search, {0, 6, 6, 3}), SearchOutcome::found);
  EXPECT_THAT(path_of(search), ElementsAre(6, 7, 8, 9));
  EXPECT_EQ(search.g(9), 3);
  EXPECT_EQ(search.arrival(6), kNoMove);
  EXPECT_EQ(search.metrics().generated, 10U) << "a start given twice counts once";
}

TEST(ForwardSearch, WithoutStartsThereIsNothingToFind) {
  Dijkstra search(row_of(3), CheapestFirst{0});
  EXPECT_EQ(search_from(search, {}), SearchOutcome::exhausted);
  EXPECT_EQ(search.metrics(), SearchMetrics{});
}

TEST(ForwardSearch, SteppingExpandsOneStateAtATimeAndEndsLikeRunning) {
  Dijkstra search(detour(), CheapestFirst{3});
  search_from(search, {0});
  const SearchMetrics run = search.metrics();
  const std::array<StateId, 1> starts{0};
  const Limits limits;
  search.begin(starts, limits);
  for (std::uint64_t steps = 1; search.outcome() == SearchOutcome::running; ++steps) {
    search.step();
    EXPECT_EQ(search.metrics().expanded, steps);
  }
  EXPECT_EQ(search.outcome(), SearchOutcome::found);
  EXPECT_EQ(search.metrics(), run);
}

TEST(ForwardSearch, StopsAtTheLimitOfExpansions) {
  Dijkstra search(row_of(1000), CheapestFirst{999});
  for (const std::uint64_t limit : {0U, 1U, 2U, 255U, 256U, 257U, 700U, 999U}) {
    Limits limits;
    limits.expansions = limit;
    EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::expansion_limit) << limit;
    EXPECT_EQ(search.metrics().expanded, limit);
  }
  Limits enough;
  enough.expansions = 1000;
  EXPECT_EQ(search_from(search, {0}, enough), SearchOutcome::found);
}

TEST(ForwardSearch, AnExhaustedSearchIsNotALimitedOne) {
  Dijkstra search(row_of(10), CheapestFirst{});
  Limits limits;
  limits.expansions = 10;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::exhausted);
  limits.expansions = 9;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::expansion_limit);
}

TEST(ForwardSearch, LooksAtTheClockAtItsStartAndEvery256Expansions) {
  Dijkstra search(row_of(1000), CheapestFirst{999});
  double now = 100;
  int readings = 0;
  Limits limits;
  limits.clock = [&] {
    ++readings;
    return now++;
  };
  limits.seconds = 1000;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::found);
  // One reading for the deadline, then one before expansions 0, 256, 512 and 768.
  EXPECT_EQ(readings, 5);

  limits.seconds = 2.5;  // the limit passes between the second and the third of those
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::time_limit);
  EXPECT_EQ(search.metrics().expanded, 512U);

  limits.seconds = 0;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::time_limit);
  EXPECT_EQ(search.metrics().expanded, 0U);

  limits.clock = nullptr;
  limits.seconds = -1;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::time_limit) << "the steady clock's";
}

TEST(ForwardSearch, IsCancelledBeforeItStartsOrWithin256Expansions) {
  struct Canceller : Diary {
    void on_expand(StateId state, Move, int) {
      if (state == 300) cancel.store(true);
    }
    std::atomic<bool> cancel = false;
  };
  Dijkstra search(row_of(1000), CheapestFirst{999});
  Canceller canceller;
  Limits limits;
  limits.cancel = &canceller.cancel;
  const std::array<StateId, 1> starts{0};
  search.begin(starts, limits, canceller);
  EXPECT_EQ(search.run(canceller), SearchOutcome::cancelled);
  EXPECT_EQ(search.metrics().expanded, 512U);

  search.begin(starts, limits, canceller);
  EXPECT_EQ(search.run(canceller), SearchOutcome::cancelled);
  EXPECT_EQ(search.metrics().expanded, 0U);

  canceller.cancel = false;
  EXPECT_EQ(search_from(search, {0}, limits), SearchOutcome::found);
}

TEST(ForwardSearch, StopsBeforeCostsOverflow) {
  Dijkstra search(row_of(1000), CheapestFirst{999, 600});
  EXPECT_EQ(search_from(search, {0}), SearchOutcome::cost_overflow);
  EXPECT_EQ(search.metrics().expanded, 768U) << "the first look at or above 600";
}

}  // namespace
}  // namespace wend
