#pragma once

// WideningEngine: searches with costs in 32 bits, which are faster, until they do not do; from then
// on with wider ones. Both must expand the same states in the same order.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "wend/planner/search_engine.hpp"

namespace wend {

template <class Engine>
class WideningEngine final : public Engine {
 public:
  using Place = typename Engine::Place;
  using Goal = typename Engine::Goal;
  using Make = std::function<std::unique_ptr<Engine>()>;

  /// How to make one for a FreeSpace, where that holds it.
  using MakeOn = std::function<std::unique_ptr<Engine>(const FreeSpace&)>;

  WideningEngine(const Make& make_compact, Make make_wide)
      : make_wide_(std::move(make_wide)), engine_(make_compact()) {}

  /// An engine that follows edits.
  WideningEngine(const FreeSpace& space, const MakeOn& make_compact, MakeOn make_wide)
      : make_wide_on_(std::move(make_wide)), space_(space), engine_(make_compact(space)) {}

  bool allocated() const override { return engine_->allocated(); }

  void begin(const Place& start, std::span<const Goal> goals, const Limits& limits,
             SearchObserver* observer) override {
    // Who watches a search must not see it begin twice.
    if (observer != nullptr) go_wide();
    if (!wide_) {
      start_ = start;
      goals_.assign(goals.begin(), goals.end());
      limits_ = &limits;
      begun_ = limits.now();
    }
    engine_->begin(start, goals, limits, observer);
  }

  SearchOutcome step() override { return unless_overflown(engine_->step()); }

  SearchOutcome run() override {
    SearchOutcome outcome = unless_overflown(engine_->run());
    while (outcome == SearchOutcome::running) outcome = engine_->run();
    return outcome;
  }

  const SearchMetrics& metrics() const override { return engine_->metrics(); }
  std::uint64_t time_taken() const override { return engine_->time_taken(); }
  OpenList open_list(std::size_t most) const override { return engine_->open_list(most); }
  double heuristic(const Place& place) const override { return engine_->heuristic(place); }
  void write_path(Path& path) const override { engine_->write_path(path); }
  std::optional<double> bound() const override { return engine_->bound(); }

  bool release() override {
    if (!make_wide_on_ || !engine_->release()) return false;
    space_.reset();
    return true;
  }
  void adopt(const FreeSpace& space) override {
    space_ = space;
    engine_->adopt(space);
  }

 private:
  void go_wide() {
    if (wide_) return;
    engine_.reset();  // its memory first
    engine_ = space_ ? make_wide_on_(*space_) : make_wide_();
    wide_ = true;
  }

  /// Begins again with wide costs, in the time that is left, if compact ones did not do.
  SearchOutcome unless_overflown(SearchOutcome outcome) {
    if (outcome != SearchOutcome::cost_overflow) return outcome;
    go_wide();
    rest_ = *limits_;
    if (rest_.timed()) rest_.seconds -= rest_.now() - begun_;
    engine_->begin(start_, goals_, rest_, nullptr);
    return SearchOutcome::running;
  }

  Make make_wide_;
  MakeOn make_wide_on_;
  std::optional<FreeSpace> space_;
  std::unique_ptr<Engine> engine_;
  bool wide_ = false;
  // What is needed to begin again.
  Place start_{};
  std::vector<Goal> goals_;
  const Limits* limits_ = nullptr;
  double begun_ = 0;
  Limits rest_;
};

}  // namespace wend
