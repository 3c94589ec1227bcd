#pragma once

// ObserverList: several observers of one search.

#include <vector>

#include "wend/planner/observer.hpp"

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

}  // namespace wend::cli
