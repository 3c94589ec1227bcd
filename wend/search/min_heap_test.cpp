#include "wend/search/min_heap.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <vector>

namespace wend {
namespace {

std::vector<int> drained(std::vector<int> heap) {
  std::vector<int> popped;
  while (!heap.empty()) popped.push_back(min_heap::pop(heap));
  return popped;
}

RC_GTEST_PROP(MinHeap, MadeOfAnythingComesOutSorted, (std::vector<int> values)) {
  std::vector<int> heap = values;
  min_heap::make(heap);
  std::sort(values.begin(), values.end());
  RC_ASSERT(drained(heap) == values);
}

RC_GTEST_PROP(MinHeap, PushesAndPopsLikeAPriorityQueue, (std::vector<int> values)) {
  std::vector<int> heap;
  std::priority_queue<int, std::vector<int>, std::greater<>> model;
  for (const int value : values) {
    if (value % 3 == 0 && !model.empty()) {
      RC_ASSERT(min_heap::pop(heap) == model.top());
      model.pop();
    } else {
      min_heap::push(heap, value);
      model.push(value);
    }
    RC_ASSERT(heap.size() == model.size());
  }
}

RC_GTEST_PROP(MinHeap, KeepsItsOrderWhenAHeapThatWasMadeIsPushedTo,
              (std::vector<int> made, std::vector<int> pushed)) {
  std::vector<int> heap = made;
  min_heap::make(heap);
  for (const int value : pushed) min_heap::push(heap, value);
  made.insert(made.end(), pushed.begin(), pushed.end());
  std::sort(made.begin(), made.end());
  RC_ASSERT(drained(heap) == made);
}

TEST(MinHeap, IsWellWithNothingAndOne) {
  std::vector<int> heap;
  min_heap::make(heap);
  EXPECT_TRUE(heap.empty());
  min_heap::push(heap, 5);
  EXPECT_EQ(min_heap::pop(heap), 5);
  EXPECT_TRUE(heap.empty());
}

}  // namespace
}  // namespace wend
