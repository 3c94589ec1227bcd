#include "cli/watching/stepped_search.hpp"

namespace wend::cli {

SteppedSearch::SteppedSearch(SearchRecorder& recorder, SearchObserver& told)
    : recorder_(recorder), told_(told) {
  observers_.add(recorder_);
  observers_.add(last_);
  observers_.add(told_);
}

std::optional<Status> SteppedSearch::begin(SearchRun& run) {
  run_ = &run;
  recorder_.clear();
  last_ = {};
  told_.begin();
  return run.restart();
}

std::optional<Status> SteppedSearch::go_on() { return run_->step(); }

std::optional<Status> SteppedSearch::go_back_to(std::uint64_t expansions) {
  auto outcome = begin(*run_);
  while (!outcome && this->expansions() < expansions) outcome = go_on();
  return outcome;
}

}  // namespace wend::cli
