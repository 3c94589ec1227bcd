#pragma once

// Narrator: tells a search on standard error as it happens, a line an event:
//
//   expand (3,4) f=9.24 g=4 h=5.24
//     generate (4,4) from (3,4) f=9.24 g=5 h=4.24
//
// A car's places have a heading: (4,4,E).

#include <limits>
#include <optional>
#include <string>

#include "wend/geometry/frame.hpp"
#include "wend/planner/observer.hpp"

namespace wend::cli {

/// Writes lines on standard error.
void tell(const std::string& lines);

class Narrator final : public SearchObserver {
 public:
  explicit Narrator(const Frame& frame) : frame_(frame) {}

  void on_generate(const SearchEvent& event) override;
  void on_expand(const SearchEvent& event) override;
  void on_relax(const SearchEvent& event) override;

 private:
  Frame frame_;
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
std::string event_text(const SearchEvent& event, const Frame& frame);

inline constexpr int kMostOpenEntries = 10;

/// With kMostOpenEntries entries at most, in at most `rows` rows, but with at least one entry.
std::string open_list_text(const OpenList& list, const Frame& frame,
                           int rows = std::numeric_limits<int>::max());

}  // namespace wend::cli
