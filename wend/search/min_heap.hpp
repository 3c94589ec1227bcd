#pragma once

// A 4-ary heap on a vector, with the smallest entry first: half as deep as a binary heap, and the four
// children are adjacent in memory.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wend::min_heap {

inline constexpr std::size_t kArity = 4;

/// Moves the entry at `hole` up to its place.
template <class Entry>
void sift_up(std::vector<Entry>& heap, std::size_t hole) {
  const Entry entry = heap[hole];
  while (hole > 0) {
    const std::size_t parent = (hole - 1) / kArity;
    if (!(entry < heap[parent])) break;
    heap[hole] = heap[parent];
    hole = parent;
  }
  heap[hole] = entry;
}

/// Moves the entry at `hole` down to its place.
template <class Entry>
void sift_down(std::vector<Entry>& heap, std::size_t hole) {
  const Entry entry = heap[hole];
  for (;;) {
    const std::size_t first = hole * kArity + 1;
    if (first >= heap.size()) break;
    const std::size_t end = std::min(first + kArity, heap.size());
    std::size_t least = first;
    for (std::size_t child = first + 1; child < end; ++child) {
      if (heap[child] < heap[least]) least = child;
    }
    if (!(heap[least] < entry)) break;
    heap[hole] = heap[least];
    hole = least;
  }
  heap[hole] = entry;
}

template <class Entry>
void push(std::vector<Entry>& heap, const Entry& entry) {
  heap.push_back(entry);
  sift_up(heap, heap.size() - 1);
}

/// Removes the smallest entry from a heap that is not empty.
template <class Entry>
Entry pop(std::vector<Entry>& heap) {
  const Entry least = heap.front();
  heap.front() = heap.back();
  heap.pop_back();
  if (!heap.empty()) sift_down(heap, 0);
  return least;
}

/// Turns any vector into a heap, in linear time.
template <class Entry>
void make(std::vector<Entry>& heap) {
  if (heap.size() < 2) return;
  for (std::size_t hole = (heap.size() - 2) / kArity + 1; hole-- > 0;) sift_down(heap, hole);
}

}  // namespace wend::min_heap
