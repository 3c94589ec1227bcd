#include "wend/report/posthoc_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "wend/base/parse.hpp"

namespace wend {
namespace {

// The value of "views", valid in JSON and in YAML: dark rectangles for the map, then a mark.
constexpr std::string_view kViewOfMap = R"({"main": [
  {"$": "rect", "$if": "${{ $.type == 'map' }}",
   "$for": {"$let": "i", "$from": 0, "$to": "${{ $.blocked.length }}", "$step": 1},
   "x": "${{ $.blocked[$.i][0] }}", "y": "${{ $.blocked[$.i][1] }}",
   "width": "${{ $.blocked[$.i][2] }}", "height": "${{ $.blocked[$.i][3] }}",
   "fill": "${{ theme.foreground }}"},
)";

constexpr std::string_view kViewOfCells =
    R"(  {"$": "rect", "$if": "${{ $.type != 'map' }}", "x": "${{ $.x }}", "y": "${{ $.y }}",
   "width": 1, "height": 1, "fill": "${{ color[$.type] }}"}]})";

// Of a unit: how far a dot lies from its corner, and how large it is, so that four have room.
constexpr double kDotDistance = 0.22;
constexpr double kDotRadius = 0.14;

/// Of a car: {0} is how far dots lie from corners, {1} their radius.
constexpr std::string_view kViewOfCorners =
    R"(  {{"$": "circle", "$if": "${{{{ $.type != 'map' }}}}",
   "x": "${{{{ $.x + {0} * (($.heading == 'E') - ($.heading == 'W')) }}}}",
   "y": "${{{{ $.y + {0} * (($.heading == 'S') - ($.heading == 'N')) }}}}",
   "radius": {1}, "fill": "${{{{ color[$.type] }}}}"}}]}})";

constexpr std::string_view kPivotOfCells =
    R"({"x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1})";
constexpr std::string_view kPivotOfCorners =
    R"({"x": "${{ $.x }}", "y": "${{ $.y }}", "scale": 1})";

std::string head(TraceForm form, int unit) {
  std::string views(kViewOfMap);
  views += unit == 0 ? std::string(kViewOfCells)
                     : fmt::format(kViewOfCorners, format_number(kDotDistance * unit),
                                   format_number(kDotRadius * unit));
  const std::string_view pivot = unit == 0 ? kPivotOfCells : kPivotOfCorners;
  if (form == TraceForm::yaml) {
    return fmt::format("version: 1.4.0\nschema: 1\nviews: {}\npivot: {}\nevents:", views, pivot);
  }
  return fmt::format(
      "{{\"version\": \"1.4.0\",\n\"schema\": 1,\n\"views\": {},\n\"pivot\": {},\n\"events\": [",
      views, pivot);
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
