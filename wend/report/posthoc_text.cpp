#include "wend/report/posthoc_text.hpp"

#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

constexpr std::string_view kYamlHead = R"(version: 1.4.0
views:
  main:
    - $: rect
      $if: ${{ $.type == 'map' }}
      $for: { $let: i, $from: 0, $to: "${{ $.blocked.length }}", $step: 1 }
      x: ${{ $.blocked[$.i][0] }}
      y: ${{ $.blocked[$.i][1] }}
      width: ${{ $.blocked[$.i][2] }}
      height: ${{ $.blocked[$.i][3] }}
      fill: ${{ theme.foreground }}
    - $: rect
      $if: ${{ $.type != 'map' }}
      x: ${{ $.x }}
      y: ${{ $.y }}
      width: 1
      height: 1
      fill: ${{ color[$.type] }}
pivot: { x: "${{ $.x + 0.5 }}", y: "${{ $.y + 0.5 }}", scale: 1 }
events:)";

constexpr std::string_view kJsonHead = R"({"version": "1.4.0",
"views": {"main": [
  {"$": "rect", "$if": "${{ $.type == 'map' }}",
   "$for": {"$let": "i", "$from": 0, "$to": "${{ $.blocked.length }}", "$step": 1},
   "x": "${{ $.blocked[$.i][0] }}", "y": "${{ $.blocked[$.i][1] }}",
   "width": "${{ $.blocked[$.i][2] }}", "height": "${{ $.blocked[$.i][3] }}",
   "fill": "${{ theme.foreground }}"},
  {"$": "rect", "$if": "${{ $.type != 'map' }}", "x": "${{ $.x }}", "y": "${{ $.y }}",
   "width": 1, "height": 1, "fill": "${{ color[$.type] }}"}]},
"pivot": {"x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1},
"events": [)";

}  // namespace

PosthocText::PosthocText(TraceForm form)
    : form_(form), text_(form == TraceForm::yaml ? kYamlHead : kJsonHead) {}

void PosthocText::begin_event(std::string_view type, std::string_view id) {
  const bool first = !in_event_;
  end_event();
  if (form_ == TraceForm::yaml) {
    text_ += "\n  - { type: ";
    text_ += type;
  } else {
    text_ += first ? "\n{\"type\":\"" : ",\n{\"type\":\"";
    text_ += type;
    text_ += '"';
  }
  in_event_ = true;
  put("id", id);
}

void PosthocText::put(std::string_view key, std::string_view json) {
  text_ += form_ == TraceForm::yaml ? ", " : ",\"";
  text_ += key;
  text_ += form_ == TraceForm::yaml ? ": " : "\":";
  text_ += json;
}

void PosthocText::put(std::string_view key, std::uint64_t value) {
  put(key, std::string_view(std::to_string(value)));
}

void PosthocText::put(std::string_view key, double value) {
  put(key, std::isfinite(value) ? std::string_view(format_number(value)) : "null");
}

void PosthocText::end_event() {
  if (in_event_) text_ += form_ == TraceForm::yaml ? " }" : "}";
}

std::string PosthocText::finish() {
  const bool empty = !in_event_;
  end_event();
  if (form_ == TraceForm::yaml) {
    text_ += empty ? " []\n" : "\n";
  } else {
    text_ += "\n]}\n";
  }
  return std::move(text_);
}

}  // namespace wend
