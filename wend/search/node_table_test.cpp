// The stores of search nodes: NodeTable and PagedNodes.

#include "wend/search/node_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <utility>

#include "wend/search/paged_nodes.hpp"

namespace wend {
namespace {

constexpr StateId kStates = 20;
constexpr StateId kStride = 100;  // so that some of them share a page and others do not

static_assert(sizeof(MoveNode<std::uint32_t>) == 8);
static_assert(sizeof(MoveNode<std::uint64_t>) == 16);
static_assert(sizeof(MoveNode<double>) == 16);
static_assert(sizeof(ParentNode<double>) == 16);

TEST(NodeTable, HasReachedNothingAtFirst) {
  NodeTable<MoveNode<int>> table(kStates);
  ASSERT_TRUE(table.allocated());
  table.begin_search();
  for (StateId id = 0; id < kStates; ++id) EXPECT_FALSE(table.reached(table[id]));
}

TEST(NodeTable, OpensClosesAndOpensAnew) {
  NodeTable<MoveNode<int>> table(kStates);
  table.begin_search();
  auto& node = table[3];
  table.open(node, 42, 7);
  EXPECT_TRUE(table.reached(node));
  EXPECT_FALSE(node.closed());
  EXPECT_EQ(node.g, 42);
  EXPECT_EQ(node.arrival(), 7);
  node.close();
  EXPECT_TRUE(node.closed());
  EXPECT_TRUE(table.reached(node));
  EXPECT_EQ(node.arrival(), 7);
  table.open(node, 41, kNoMove);
  EXPECT_FALSE(node.closed());
  EXPECT_EQ(node.g, 41);
  EXPECT_EQ(node.arrival(), kNoMove);
}

TEST(NodeTable, KeepsAnyParentAndReplacesIt) {
  NodeTable<ParentNode<double>> table(kStates);
  table.begin_search();
  auto& node = table[3];
  table.open(node, 4.5, 19);
  node.close();
  node.replace(5.5, 2);
  EXPECT_EQ(node.g, 5.5);
  EXPECT_EQ(node.arrival(), 2U);
  EXPECT_TRUE(node.closed() && table.reached(node));
}

TEST(NodeTable, EveryArrivalFits) {
  NodeTable<MoveNode<int>> table(kNoMove + 1U);
  table.begin_search();
  for (unsigned move = 0; move <= kNoMove; ++move) {
    table.open(table[move], 0, static_cast<Move>(move));
    EXPECT_EQ(table[move].arrival(), move);
  }
}

/// A node that was reached in the first generation 1 must not count in the next generation 1.
TEST(NodeTable, ForgetsNodesOfEveryGenerationWhenTheGenerationsRunOut) {
  constexpr unsigned kBits = 2;
  NodeTable<MoveNode<int>, kBits> table(kStates);
  for (StateId search = 0; search < 3U << kBits; ++search) {
    table.begin_search();
    for (StateId id = 0; id < kStates; ++id) {
      ASSERT_FALSE(table.reached(table[id])) << "search " << search << ", state " << id;
    }
    table.open(table[search % kStates], 1, 0);
    ASSERT_TRUE(table.reached(table[search % kStates]));
  }
}

/// Compares any sequence of searches, over any number of wraps, with a map that is cleared.
template <class Store>
void behaves_like_a_map() {
  using Node = typename Store::Node;
  using Arrival = typename Node::Arrival;
  struct Known {
    int g;
    Arrival arrival;
    bool closed;
  };
  Store table(kStates * kStride);
  const auto searches = *rc::gen::inRange(1, 40);
  for (int search = 0; search < searches; ++search) {
    table.begin_search();
    std::map<StateId, Known> model;
    const auto ids =
        *rc::gen::container<std::vector<StateId>>(rc::gen::inRange(StateId{0}, kStates));
    for (const StateId number : ids) {
      const StateId id = kStride * number;
      const auto g = *rc::gen::arbitrary<int>();
      const auto arrival = *rc::gen::element<Arrival>(0, 1, Node::kNoArrival - 1, Node::kNoArrival);
      table.open(*table.room_for(id), g, arrival);
      model[id] = {g, arrival, *rc::gen::arbitrary<bool>()};
      if (model[id].closed) table[id].close();
    }
    for (StateId id = 0; id < kStates * kStride; id += kStride / 2) {
      const auto known = model.find(id);
      const Node& node = std::as_const(table)[id];
      RC_ASSERT(table.reached(node) == (known != model.end()));
      if (known == model.end()) continue;
      RC_ASSERT(node.g == known->second.g);
      RC_ASSERT(node.arrival() == known->second.arrival);
      RC_ASSERT(node.closed() == known->second.closed);
    }
  }
}

RC_GTEST_PROP(NodeTable, BehavesLikeAMap, ()) {
  behaves_like_a_map<NodeTable<MoveNode<int>>>();
  behaves_like_a_map<NodeTable<ParentNode<int>>>();
}
RC_GTEST_PROP(NodeTable, BehavesLikeAMapWithFewGenerations, ()) {
  behaves_like_a_map<NodeTable<ParentNode<int>, 1>>();
  behaves_like_a_map<NodeTable<MoveNode<int>, 1>>();
  behaves_like_a_map<NodeTable<MoveNode<int>, 3>>();
}

RC_GTEST_PROP(PagedNodes, BehavesLikeAMap, ()) {
  behaves_like_a_map<PagedNodes<MoveNode<int>>>();
  behaves_like_a_map<PagedNodes<ParentNode<int>>>();
}
RC_GTEST_PROP(PagedNodes, BehavesLikeAMapWithFewGenerations, ()) {
  behaves_like_a_map<PagedNodes<ParentNode<int>, 1>>();
  behaves_like_a_map<PagedNodes<MoveNode<int>, 3>>();
}

}  // namespace
}  // namespace wend
