#include "wend/report/posthoc_trace.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "wend/base/parse.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/corner_pose.hpp"
#include "wend/map/joined_rows.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostRectangles = 10'000;  // 100 KB, and quickly drawn

struct Rectangle {
  int x;
  int y;
  int width;
  int height;
};

/// The blocked cells of row y, from left to right.
template <class IsBlocked>
std::vector<Rectangle> blocked_runs(int width, int y, IsBlocked&& is_blocked) {
  std::vector<Rectangle> runs;
  for_runs(
      width, [&](int x) { return is_blocked(Cell{x, y}); },
      [&](int x, int length, bool blocked) {
        if (blocked) runs.push_back({x, y, length, 1});
      });
  return runs;
}

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

constexpr std::string_view kViewOfWays =
    R"(  {"$": "path", "$if": "${{ !!$.way }}", "points": "${{ $.way }}", "line-width": 0.25,
   "fill": "${{ color[$.type] }}"},
)";

// In spacings: the distance of a dot from its corner, and its size, so that four dots fit.
constexpr double kDotDistance = 0.22;
constexpr double kDotRadius = 0.14;

/// For a car: {0} is the distance of dots from vertices, {1} their radius.
constexpr std::string_view kViewOfCorners =
    R"(  {{"$": "circle", "$if": "${{{{ $.type != 'map' }}}}",
   "x": "${{{{ $.x + {0} * (($.heading == 'E') - ($.heading == 'W')) }}}}",
   "y": "${{{{ $.y + {0} * (($.heading == 'S') - ($.heading == 'N')) }}}}",
   "radius": {1}, "fill": "${{{{ color[$.type] }}}}"}}]}})";

constexpr std::string_view kPivotOfCells =
    R"({"x": "${{ $.x + 0.5 }}", "y": "${{ $.y + 0.5 }}", "scale": 1})";
constexpr std::string_view kPivotOfCorners =
    R"({"x": "${{ $.x }}", "y": "${{ $.y }}", "scale": 1})";

std::string head(TraceForm form, const PlaceGrid& places, bool ways) {
  std::string views(kViewOfMap);
  if (ways) views += kViewOfWays;
  views += !places.on_corners()
               ? std::string(kViewOfCells)
               : fmt::format(kViewOfCorners, format_number(kDotDistance * places.spacing),
                             format_number(kDotRadius * places.spacing));
  const std::string_view pivot = places.on_corners() ? kPivotOfCorners : kPivotOfCells;
  if (form == TraceForm::yaml) {
    return fmt::format("version: 1.4.0\nschema: 1\nviews: {}\npivot: {}\nevents:", views, pivot);
  }
  return fmt::format(
      "{{\"version\": \"1.4.0\",\n\"schema\": 1,\n\"views\": {},\n\"pivot\": {},\n\"events\": [",
      views, pivot);
}

}  // namespace

PosthocText::PosthocText(TraceForm form, const PlaceGrid& places, bool ways)
    : form_(form), text_(head(form, places, ways)) {}

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

PosthocTrace::PosthocTrace(const FreeSpace& space, const PlaceGrid& places, bool ways,
                           TraceForm form, std::uint64_t most_events)
    : map_height_(space.height()),
      places_(places),
      width_(space.width() + (places.on_corners() ? 1 : 0)),
      height_(space.height() + (places.on_corners() ? 1 : 0)),
      frame_(space.map().frame()),
      room_(most_events),
      text_(form, places, ways) {
  put_map(space);
}

PosthocTrace::PosthocTrace(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                           TraceForm form, std::uint64_t most_events)
    : PosthocTrace(space, cells_of(space), false, form, most_events) {
  put_end("source", {start});
  for (const Cell goal : goals) put_end("destination", {goal});
}

PosthocTrace::PosthocTrace(const FreeSpace& space, const Query& query, const PlaceGrid& places,
                           TraceForm form, std::uint64_t most_events)
    : PosthocTrace(space, places, !places.on_corners(), form, most_events) {
  if (const auto start = place_of(query.start)) put_end("source", *start);
  for (const Goal& goal : query.goals) {
    auto place = place_of({goal.point.x, goal.point.y, goal.heading.value_or(0)});
    if (!place) continue;
    if (goal.heading) put_end("destination", *place);
    if (goal.heading) continue;
    for (const Heading heading : kAllHeadings) {
      put_end("destination", {place->cell, radians_of(heading)});
    }
  }
}

void PosthocTrace::put_map(const FreeSpace& space) {
  const auto is_blocked = [&](Cell cell) {
    return places_.on_corners() ? space.obstacles().blocked()[cell] : !space.passable()[cell];
  };
  const auto rectangles = joined_rows<Rectangle>(
      map_height_, kMostRectangles,
      [&](int y) { return blocked_runs(space.width(), y, is_blocked); },
      [](const Rectangle&, const Rectangle&) { return true; });
  if (!rectangles || rectangles->empty()) return;
  std::string blocked = "[";
  for (const Rectangle& cells : *rectangles) {
    const int top = frame_.y_up ? map_height_ - cells.y - cells.height : cells.y;
    fmt::format_to(std::back_inserter(blocked), "{}[{},{},{},{}]", blocked.size() > 1 ? "," : "",
                   cells.x, top, cells.width, cells.height);
  }
  text_.begin_event("map", "\"map\"");
  text_.put("blocked", std::string_view(blocked + "]"));
}

bool PosthocTrace::contains(Cell cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_;
}

/// The number of places before this one.
std::uint64_t PosthocTrace::number(const Place& place) const {
  const auto number =
      static_cast<std::uint64_t>(place.cell.y) * static_cast<std::uint64_t>(width_) +
      static_cast<std::uint64_t>(place.cell.x);
  if (!place.heading) return number;
  if (places_.on_corners())
    return number * kHeadings + static_cast<std::uint64_t>(nearest_heading(*place.heading));
  // No lattice has headings as close as this.
  constexpr std::uint64_t kSteps = 4096;
  const double turns = *place.heading / (2 * kPi);
  const auto step = static_cast<std::uint64_t>(std::llround((turns - std::floor(turns)) * kSteps));
  return number * kSteps + step % kSteps;
}

/// The place on the lattice of a car in this pose.
std::optional<PosthocTrace::Place> PosthocTrace::place_of(const Pose& pose) const {
  if (!places_.on_corners()) return Place{cell_at(pose.point()), pose.heading};
  const auto nearest = nearest_corner_pose(pose, places_.spacing);
  if (!nearest) return std::nullopt;
  return Place{nearest->vertex, radians_of(nearest->heading)};
}

PosthocTrace::Node& PosthocTrace::node_of(const Place& place) {
  return nodes_.try_emplace(number(place), Node{number(place)}).first->second;
}

/// Is there room for one more event? Once there is none, no further events are kept.
bool PosthocTrace::keep_one() {
  if (room_ == 0) {
    ++dropped_;
    return false;
  }
  --room_;
  return true;
}

void PosthocTrace::on_generate(const SearchEvent& event) {
  if (!keep_one()) return;
  const std::uint64_t id = number({event.cell, event.heading});
  const auto [place, is_first] = nodes_.try_emplace(id, Node{id});
  Node& node = place->second;
  // A walk that returns to a cell.
  if (!is_first)
    node.id += static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_);
  put_event("generating", event, node);
}

void PosthocTrace::on_expand(const SearchEvent& event) {
  close_expanded();
  const Place place{event.cell, event.heading};
  expanded_ = place;
  if (keep_one()) put_event("expanding", event, node_of(place));
}

void PosthocTrace::on_relax(const SearchEvent& event) {
  if (keep_one()) put_event("updating", event, node_of({event.cell, event.heading}));
}

void PosthocTrace::close_expanded() {
  if (!expanded_) return;
  const Place place = *expanded_;
  expanded_.reset();
  if (keep_one()) put_event("closing", place, node_of(place).id);
}

std::string PosthocTrace::finish(const Path& path) {
  close_expanded();
  if (const auto end = end_of(path)) {
    put_event("end", *end, node_of(*end).id);
    put_parent(node_of(*end));
  }
  return text_.finish();
}

std::optional<PosthocTrace::Place> PosthocTrace::end_of(const Path& path) const {
  if (path.empty()) return std::nullopt;
  return path.visit(
      [&](const JoinedPoses& joined) { return place_of(joined.poses().back()); },
      [&](const auto&) { return std::optional(Place{cell_at(path.points().back())}); });
}

/// A start or a goal, if it is on the map.
void PosthocTrace::put_end(std::string_view type, const Place& place) {
  if (contains(place.cell)) put_event(type, place, number(place));
}

void PosthocTrace::put_event(std::string_view type, const Place& place, std::uint64_t id) {
  text_.begin_event(type, std::to_string(id));
  text_.put("x", static_cast<std::uint64_t>(place.cell.x));
  text_.put("y",
            static_cast<std::uint64_t>(frame_.y_up ? height_ - 1 - place.cell.y : place.cell.y));
  if (place.heading) text_.put("heading", json_of_heading(*place.heading, frame_).dump());
}

void PosthocTrace::put_event(std::string_view type, const SearchEvent& event, Node& node) {
  node.parent.reset();
  if (event.parent) {
    const auto parent = nodes_.find(number({*event.parent, event.parent_heading}));
    if (parent != nodes_.end()) node.parent = parent->second.id;
  }
  put_event(type, Place{event.cell, event.heading}, node.id);
  put_parent(node);
  text_.put("f", event.f);
  text_.put("g", event.g);
  text_.put("h", event.h);
  if (event.way.size() > 1) put_way(event.way);
}

void PosthocTrace::put_parent(const Node& node) {
  text_.put("pId", std::string_view(node.parent ? std::to_string(*node.parent) : "null"));
}

void PosthocTrace::put_way(std::span<const Pose> way) {
  std::string points;
  for (const Pose& pose : way) {
    const double y = frame_.y_up ? map_height_ - pose.y : pose.y;
    fmt::format_to(std::back_inserter(points), R"({}{{"x": {:.3f}, "y": {:.3f}}})",
                   points.empty() ? "[" : ", ", pose.x, y);
  }
  text_.put("way", std::string_view(points + "]"));
}

}  // namespace wend
