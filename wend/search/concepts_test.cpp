// Archetypes: for each concept a type that provides exactly what the concept requires. If the search
// compiles and works with them, it requires no more than its concepts say.

#include "wend/search/concepts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

#include "wend/search/forward_search.hpp"
#include "wend/search/frontiers.hpp"

namespace wend {
namespace {

/// Can be made from a small number, added and compared with <.
struct ArchetypeCost {
  int value;

  friend ArchetypeCost operator+(ArchetypeCost a, ArchetypeCost b) { return {a.value + b.value}; }
  friend bool operator<(ArchetypeCost a, ArchetypeCost b) { return a.value < b.value; }
};

/// Can be copied, and made from nothing.
struct ArchetypeState {
  StateId hidden = 0;
};

/// Converts to the type that a concept names, but is a different type.
template <class T>
struct ConvertibleTo {
  T value;
  operator T() const { return value; }  // NOLINT(google-explicit-constructor): that is its purpose
};

/// Ten states in a row; move 0 leads to the next one.
class ArchetypeSpace {
 public:
  using State = ArchetypeState;
  using Cost = ArchetypeCost;

  ArchetypeSpace(ArchetypeSpace&&) = default;  // a search takes it over
  explicit ArchetypeSpace(StateId count) : count_(count) {}

  ConvertibleTo<StateId> state_count() const { return {count_}; }
  State state(StateId id) const { return {id}; }
  ConvertibleTo<StateId> id(const State& state) const { return {state.hidden}; }
  State parent(const State& state, Move /*move*/) const { return {state.hidden - 1}; }

  template <class Sink>
  void for_each_successor(const State& state, Move /*arrival*/, Sink&& sink) const {
    if (state.hidden + 1 < count_) sink(State{state.hidden + 1}, Move{0}, Cost{1});
  }

 private:
  StateId count_;
};

/// Can be copied.
struct ArchetypeKey {
  int number;
};

class ArchetypePriority {
 public:
  using Key = ArchetypeKey;

  ArchetypePriority(ArchetypePriority&&) = default;
  explicit ArchetypePriority(StateId goal) : goal_(goal) {}

  Key key(const ArchetypeState& /*state*/, ArchetypeCost g) const { return {g.value}; }
  ConvertibleTo<bool> is_goal(const ArchetypeState& state) const { return {state.hidden == goal_}; }
  ConvertibleTo<bool> near_overflow(ArchetypeKey /*key*/) const { return {false}; }

 private:
  StateId goal_;
};

/// Holds one state at a time, which is enough for states in a row.
class ArchetypeFrontier {
 public:
  using Key = ArchetypeKey;
  struct Entry {
    StateId id;
    Key key;
  };

  void clear() { full_ = false; }
  bool empty() { return !full_; }
  void push(Key key, StateId id) {
    entry_ = {id, key};
    full_ = true;
  }
  Entry pop() {
    full_ = false;
    return entry_;
  }

 private:
  Entry entry_{};
  bool full_ = false;
};

struct ArchetypeWatcher {
  void on_generate(const ArchetypeState&, Move, ArchetypeCost) { ++generated; }
  void on_expand(const ArchetypeState&, Move, ArchetypeCost) { ++expanded; }
  void on_relax(const ArchetypeState&, Move, ArchetypeCost) { ++relaxed; }

  int generated = 0;
  int expanded = 0;
  int relaxed = 0;
};

static_assert(SearchSpace<ArchetypeSpace>);
static_assert(SearchPriority<ArchetypePriority, ArchetypeSpace>);
static_assert(SearchFrontier<ArchetypeFrontier>);
static_assert(SearchWatcher<ArchetypeWatcher, ArchetypeSpace>);
static_assert(SearchWatcher<NoObserver, ArchetypeSpace>);
static_assert(SearchFrontier<FifoFrontier> && SearchFrontier<LifoFrontier>);
static_assert(SearchFrontier<HeapFrontier<int>>);

// The concepts reject types that lack what they require.
struct Nothing {};
static_assert(!SearchSpace<Nothing>);
static_assert(!SearchPriority<Nothing, ArchetypeSpace>);
static_assert(!SearchFrontier<Nothing>);
static_assert(!SearchWatcher<Nothing, ArchetypeSpace>);
static_assert(!SearchFrontier<ArchetypePriority> && !SearchSpace<ArchetypeFrontier>);

template <DuplicateRule kDuplicates>
void search_a_row() {
  ForwardSearch<ArchetypeSpace, ArchetypeFrontier, ArchetypePriority, kDuplicates> search(
      ArchetypeSpace(10), ArchetypePriority(7));
  const std::array starts{ArchetypeState{2}};
  const Limits limits;
  ArchetypeWatcher watcher;
  search.begin(starts, limits, watcher);
  EXPECT_EQ(search.run(watcher), SearchOutcome::found);
  EXPECT_EQ(watcher.expanded, 6);
  EXPECT_EQ(watcher.generated, 6);
  EXPECT_EQ(watcher.relaxed, 0);
  EXPECT_EQ(search.g(7).value, 5);

  std::size_t states = 0;
  search.for_each_back_from(search.goal(), [&](const ArchetypeState&) { ++states; });
  EXPECT_EQ(states, 6U);
}

TEST(Archetypes, AreAllThatASearchNeeds) {
  search_a_row<DuplicateRule::keep_first>();
  search_a_row<DuplicateRule::keep_cheaper>();
}

}  // namespace
}  // namespace wend
