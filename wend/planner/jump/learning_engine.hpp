#pragma once

// LearningEngine: scans the cells of the map at first, and searches on what PreparedJumps have of it once that is
// there. Both give the same paths.

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "wend/planner/jump/jump_engine.hpp"
#include "wend/planner/jump/prepared_jumps.hpp"

namespace wend {

template <class Cost>
class LearningEngine final : public GridEngine {
 public:
  /// `passable` must live as long.
  LearningEngine(std::shared_ptr<PreparedJumps> prepared, const BitGrid& passable)
      : prepared_(std::move(prepared)), passable_(&passable) {}

  LearningEngine(const LearningEngine&) = delete;
  LearningEngine& operator=(const LearningEngine&) = delete;

  /// Leaves its memory to the next planner.
  ~LearningEngine() override {
    give_back_scanning();
    if (known_ != nullptr) prepared_->give_back(known_->take_search());
  }

  bool allocated() const override { return true; }

  void begin(const Cell& start, std::span<const GoalRegion> goals, const Limits& limits,
             SearchObserver* observer) override {
    if (known_ == nullptr) choose();
    engine_->begin(start, goals, limits, observer);
  }

  SearchOutcome step() override { return engine_->step(); }
  SearchOutcome run() override { return engine_->run(); }
  const SearchMetrics& metrics() const override { return engine_->metrics(); }
  std::uint64_t time_taken() const override { return engine_->time_taken(); }
  OpenList open_list(std::size_t most) const override {
    return engine_ == nullptr ? OpenList{} : engine_->open_list(most);
  }
  double heuristic(const Cell& cell) const override {
    return engine_ == nullptr ? 0 : engine_->heuristic(cell);
  }
  void write_path(Path& path) const override { engine_->write_path(path); }

 private:
  using Scanned = ScannedJumps<Cost>;
  using Known = KnownJumps<Cost>;

  void choose() {
    if (scanning_ != nullptr) count_scans();
    if (auto search = prepared_->template known<Cost>(*passable_)) {
      scanning_.reset();  // its memory first
      known_ = std::make_unique<JumpEngine<Known>>(std::move(search));
      engine_ = known_.get();
    } else if (scanning_ == nullptr) {
      scanning_ =
          std::make_unique<JumpEngine<Scanned>>(prepared_->template scanning<Cost>(*passable_));
      scans_ = scanning_->jumps().ground().scans();
      engine_ = scanning_.get();
    }
  }

  void count_scans() {
    const std::uint64_t before = std::exchange(scans_, scanning_->jumps().ground().scans());
    prepared_->count_scans(scans_ - before);
  }

  void give_back_scanning() {
    if (scanning_ == nullptr) return;
    count_scans();
    prepared_->give_back(scanning_->take_search());
  }

  std::shared_ptr<PreparedJumps> prepared_;
  const BitGrid* passable_;
  std::unique_ptr<JumpEngine<Scanned>> scanning_;
  std::uint64_t scans_ = 0;  // that have been counted
  std::unique_ptr<JumpEngine<Known>> known_;
  GridEngine* engine_ = nullptr;  // one of the two, from the first query on
};

}  // namespace wend
