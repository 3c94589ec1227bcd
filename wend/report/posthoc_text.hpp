#pragma once

// PosthocText: the text of a Posthoc trace, version 1.4.0, event by event: what a PosthocTrace
// writes with. The views are fixed: dark rectangles for the event of type "map", whose `blocked`
// lists [x, y, width, height], and for every other event a mark in its type's colour: the square of
// a cell, or of a car a dot beside its corner, on the side that its `heading` faces.

#include <cstdint>
#include <string>
#include <string_view>

namespace wend {

/// JSON, or YAML of the same shape.
enum class TraceForm { yaml, json };

class PosthocText {
 public:
  /// The corners of a car lie `unit` cells apart; 0: cells.
  explicit PosthocText(TraceForm form, int unit = 0);

  /// An event, `id` being JSON. Everything that is put until the next one belongs to it.
  void begin_event(std::string_view type, std::string_view id);

  /// `json` is valid JSON on one line.
  void put(std::string_view key, std::string_view json);
  void put(std::string_view key, std::uint64_t value);
  void put(std::string_view key, double value);  // null if it is not finite

  /// The whole text. Nothing may be put any more.
  std::string finish();

 private:
  void end_event();

  TraceForm form_;
  bool in_event_ = false;
  std::string text_;
};

}  // namespace wend
