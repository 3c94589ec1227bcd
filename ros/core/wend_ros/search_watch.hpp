#pragma once

// SearchWatch: an observer that other threads may ask how far a search is and which paths it has found, and that
// remembers the order of expansion on request.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "wend/geometry/cell.hpp"
#include "wend/planner/observer.hpp"
#include "wend/planner/plan.hpp"

namespace wend_ros {

/// The paths that a search has found so far.
struct Solutions {
  std::uint32_t count = 0;
  double cost = 0;   // of the last one; 0 without
  double bound = 0;  // of the same
};

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

  /// For wend::OnSolution.
  void on_solution(const wend::Plan& plan) {
    const std::lock_guard lock(mutex_);
    solutions_ = {solutions_.count + 1, plan.cost, plan.bound};
  }

  Solutions solutions() const {
    const std::lock_guard lock(mutex_);
    return solutions_;
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
  mutable std::mutex mutex_;
  Solutions solutions_;  // guarded by mutex_
};

}  // namespace wend_ros
