#include "wend/report/posthoc_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

constexpr std::string_view kYamlViews = R"(version: 1.4.0
schema: 1
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
)";

constexpr std::string_view kYamlCells = R"(    - $: rect
      $if: ${{ $.type != 'map' }}
      x: ${{ $.x }}
      y: ${{ $.y }}
      width: 1
      height: 1
      fill: ${{ color[$.type] }}
pivot: { x: "${{ $.x + 0.5 }}", y: "${{ $.y + 0.5 }}", scale: 1 }
events:)";

constexpr std::string_view kJsonViews = R"({"version": "1.4.0",
"schema": 1,
"views": {"main": [
  {"$": "rect", "$if": "${{ $.type == 'map' }}",
   "$for": {"$let": "i", "$from": 0, "$to": "${{ $.blocked.length }}", "$step": 1},
   "x": "${{ $.blocked[$.i][0] }}", "y": "${{ $.blocked[$.i][1] }}",
   "width": "${{ $.blocked[$.i][2] }}", "height": "${{ $.blocked[$.i][3] }}",
   "fill": "${{ theme.foreground }}"},
)";

constexpr std::string_view kJsonCells =
    R"(  {"$": "rect", "$if": "${{ $.type != 'map' }}", "x": "${{ $.x }}", "y": "${{ $.y }}",
   "width": 1, "height": 1, "fill": "${{ color[$.type] }}"}]},
"pivot": {"x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1},
"events": [)";

// Of a unit: how far a dot lies from its corner, and how large it is, so that four have room.
constexpr double kDotDistance = 0.22;
constexpr double kDotRadius = 0.14;

/// The heads of a car's trace: {0} is how far dots lie from corners, {1} their radius.
constexpr std::string_view kYamlCorners = R"(    - $: circle
      $if: ${{{{ $.type != 'map' }}}}
      x: ${{{{ $.x + {0} * (($.heading == 'E') - ($.heading == 'W')) }}}}
      y: ${{{{ $.y + {0} * (($.heading == 'S') - ($.heading == 'N')) }}}}
      radius: {1}
      fill: ${{{{ color[$.type] }}}}
pivot: {{ x: "${{{{ $.x }}}}", y: "${{{{ $.y }}}}", scale: 1 }}
events:)";

constexpr std::string_view kJsonCorners =
    R"(  {{"$": "circle", "$if": "${{{{ $.type != 'map' }}}}",
   "x": "${{{{ $.x + {0} * (($.heading == 'E') - ($.heading == 'W')) }}}}",
   "y": "${{{{ $.y + {0} * (($.heading == 'S') - ($.heading == 'N')) }}}}",
   "radius": {1}, "fill": "${{{{ color[$.type] }}}}"}}]}},
"pivot": {{"x": "${{{{ $.x }}}}", "y": "${{{{ $.y }}}}", "scale": 1}},
"events": [)";

std::string head(TraceForm form, int unit) {
  const bool yaml = form == TraceForm::yaml;
  std::string text(yaml ? kYamlViews : kJsonViews);
  if (unit == 0) return text.append(yaml ? kYamlCells : kJsonCells);
  const std::string distance = format_number(kDotDistance * unit);
  const std::string radius = format_number(kDotRadius * unit);
  return text + (yaml ? fmt::format(kYamlCorners, distance, radius)
                      : fmt::format(kJsonCorners, distance, radius));
}

}  // namespace

PosthocText::PosthocText(TraceForm form, int unit) : form_(form), text_(head(form, unit)) {}

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
