#pragma once

// Narrator: tells a search on standard error as it happens, a line an event:
//
//   expand (3,4) f=9.24 g=4 h=5.24
//     generate (4,4) from (3,4) f=9.24 g=5 h=4.24
//
// Of a car with the heading: (4,4,E).

#include <optional>
#include <string>

#include "wend/planner/observer.hpp"

namespace wend::cli {

/// Writes lines on standard error.
void tell(const std::string& lines);

class Narrator final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override;
  void on_expand(const SearchEvent& event) override;
  void on_relax(const SearchEvent& event) override;
};

/// Keeps what was expanded last.
class LastExpansion final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& /*event*/) override {}
  void on_expand(const SearchEvent& event) override { event_ = event; }
  void on_relax(const SearchEvent& /*event*/) override {}

  /// Nothing before the first expansion.
  const std::optional<SearchEvent>& event() const { return event_; }

 private:
  std::optional<SearchEvent> event_;
};

/// "(3,4) f=9.24 g=4 h=5.24"
std::string event_text(const SearchEvent& event);

inline constexpr int kMostOpenEntries = 10;

/// In at most `rows` rows, but with at least one entry.
std::string open_list_text(const OpenList& list, int rows);

/// With kMostOpenEntries entries at most.
std::string open_list_text(const OpenList& list);

}  // namespace wend::cli
