#pragma once

// SteppedSearch: a search that goes forward and back, one expansion at a time. Searches are
// deterministic: to go back, it restarts and stops earlier, so that the recorder, the plan and the
// open list are those of that moment.

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/watching/narrator.hpp"
#include "wend/analysis/search_recorder.hpp"
#include "wend/planner/observer.hpp"
#include "wend/session/search_run.hpp"

namespace wend::cli {

class ObserverList final : public SearchObserver {
 public:
  /// It must outlive the search. Observers are told in the order in which they were added.
  void add(SearchObserver& observer) { observers_.push_back(&observer); }

  bool empty() const { return observers_.empty(); }

  void on_generate(const SearchEvent& event) override {
    for (SearchObserver* observer : observers_) observer->on_generate(event);
  }
  void on_expand(const SearchEvent& event) override {
    for (SearchObserver* observer : observers_) observer->on_expand(event);
  }
  void on_relax(const SearchEvent& event) override {
    for (SearchObserver* observer : observers_) observer->on_relax(event);
  }

 private:
  std::vector<SearchObserver*> observers_;
};

/// Passes only new events on to an observer, although the search restarts again and again.
class ToldOnce final : public SearchObserver {
 public:
  /// It must outlive this.
  explicit ToldOnce(SearchObserver& observer) : observer_(observer) {}

  /// The search begins again.
  void begin() { events_ = 0; }

  void on_generate(const SearchEvent& event) override {
    if (is_new()) observer_.on_generate(event);
  }
  void on_expand(const SearchEvent& event) override {
    if (is_new()) observer_.on_expand(event);
  }
  void on_relax(const SearchEvent& event) override {
    if (is_new()) observer_.on_relax(event);
  }

 private:
  bool is_new() {
    if (++events_ <= told_) return false;
    told_ = events_;
    return true;
  }

  SearchObserver& observer_;
  std::uint64_t events_ = 0;  // of the current run of the search
  std::uint64_t told_ = 0;    // the most events of any run
};

class SteppedSearch {
 public:
  /// `told` gets every event once, however often the search goes back. Both must outlive this.
  SteppedSearch(SearchRecorder& recorder, SearchObserver& told);

  /// What has to watch the search.
  SearchObserver& observer() { return observers_; }

  /// Goes to before the first expansion of a run, which must outlive this. An outcome if the search is over.
  std::optional<Status> begin(SearchRun& run);

  /// Makes one expansion. An outcome if the search is over.
  std::optional<Status> go_on();

  /// Goes back to the state after this number of expansions. An outcome if the search is over.
  std::optional<Status> go_back_to(std::uint64_t expansions);

  std::uint64_t expansions() const { return run_->plan().metrics.expanded; }

  /// What was expanded last; nothing before the first expansion.
  const std::optional<SearchEvent>& last_expansion() const { return last_.event(); }

 private:
  SearchRecorder& recorder_;
  ToldOnce told_;
  LastExpansion last_;
  ObserverList observers_;
  SearchRun* run_ = nullptr;
};

}  // namespace wend::cli
