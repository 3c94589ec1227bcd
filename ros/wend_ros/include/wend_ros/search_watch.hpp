#pragma once

// SearchWatch: an observer that other threads may ask how far a search is, and that remembers the
// order of expansion if it is told to.

#include <atomic>
#include <cstdint>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/planner/observer.hpp"

namespace wend_ros {

class SearchWatch final : public wend::SearchObserver {
 public:
  explicit SearchWatch(bool keeps_order) : keeps_order_(keeps_order) {}

  void on_generate(const wend::SearchEvent&) override {}
  void on_relax(const wend::SearchEvent&) override {}
  void on_expand(const wend::SearchEvent& event) override {
    expanded_.fetch_add(1, std::memory_order_relaxed);
    f_.store(event.f, std::memory_order_relaxed);
    if (keeps_order_) order_.push_back(event.cell);
  }

  std::uint64_t expanded() const { return expanded_.load(std::memory_order_relaxed); }

  /// The priority of the state expanded last: where priorities never fall, no path is cheaper.
  double f() const { return f_.load(std::memory_order_relaxed); }

  /// Not while the search runs.
  const std::vector<wend::Cell>& order() const { return order_; }

 private:
  bool keeps_order_;
  std::atomic<std::uint64_t> expanded_{0};
  std::atomic<double> f_{0};
  std::vector<wend::Cell> order_;
};

}  // namespace wend_ros
