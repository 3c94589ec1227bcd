#pragma once

// PosthocText: the text of a Posthoc trace, version 1.4.0, event by event: what a PosthocTrace
// writes with. The views are fixed: a square for every event in its type's colour, and dark
// rectangles for the event of type "map", whose `blocked` lists [x, y, width, height].

#include <cstdint>
#include <string>
#include <string_view>

namespace wend {

/// JSON, or YAML of the same shape.
enum class TraceForm { yaml, json };

class PosthocText {
 public:
  explicit PosthocText(TraceForm form);

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
