#include "wend/report/posthoc_trace.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "wend/map/joined_rows.hpp"

namespace wend {
namespace {

constexpr std::size_t kMostRectangles = 10'000;  // 100 KB, and soon drawn

struct Rectangle {
  int x;
  int y;
  int width;
  int height;
};

/// The blocked cells of row y, from left to right.
std::vector<Rectangle> blocked_runs(const FreeSpace& space, int y) {
  std::vector<Rectangle> runs;
  bool blocked = false;
  for (int x = 0; x < space.width(); ++x) {
    const bool joins = blocked;
    blocked = !space.passable()[{x, y}];
    if (!blocked) continue;
    if (joins) {
      ++runs.back().width;
    } else {
      runs.push_back({x, y, 1, 1});
    }
  }
  return runs;
}

}  // namespace

PosthocTrace::PosthocTrace(const FreeSpace& space, Cell start, std::span<const Cell> goals,
                           TraceForm form, std::uint64_t most_events)
    : width_(space.width()),
      height_(space.height()),
      y_up_(space.map().frame().y_up),
      room_(most_events),
      text_(form) {
  put_map(space);
  if (space.contains(start)) put_event("source", start, number(start));
  for (const Cell goal : goals) {
    if (space.contains(goal)) put_event("destination", goal, number(goal));
  }
}

void PosthocTrace::put_map(const FreeSpace& space) {
  const auto rectangles = joined_rows<Rectangle>(
      height_, kMostRectangles, [&](int y) { return blocked_runs(space, y); },
      [](const Rectangle&, const Rectangle&) { return true; });
  if (!rectangles || rectangles->empty()) return;
  std::string blocked = "[";
  for (const Rectangle& cells : *rectangles) {
    const int top = y_up_ ? height_ - cells.y - cells.height : cells.y;
    fmt::format_to(std::back_inserter(blocked), "{}[{},{},{},{}]", blocked.size() > 1 ? "," : "",
                   cells.x, top, cells.width, cells.height);
  }
  text_.begin_event("map", "\"map\"");
  text_.put("blocked", std::string_view(blocked + "]"));
}

std::uint64_t PosthocTrace::number(Cell cell) const {
  return static_cast<std::uint64_t>(cell.y) * static_cast<std::uint64_t>(width_) +
         static_cast<std::uint64_t>(cell.x);
}

PosthocTrace::Node& PosthocTrace::node_of(Cell cell) {
  return nodes_.try_emplace(number(cell), Node{number(cell)}).first->second;
}

/// Is there room for one more event? Once there was none, nothing is kept any more.
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
  const auto [place, is_first] = nodes_.try_emplace(number(event.cell), Node{number(event.cell)});
  Node& node = place->second;
  if (!is_first)
    node.id += static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_);
  put_event("generating", event, node);
}

void PosthocTrace::on_expand(const SearchEvent& event) {
  close_expanded();
  expanded_ = event.cell;
  if (keep_one()) put_event("expanding", event, node_of(event.cell));
}

void PosthocTrace::on_relax(const SearchEvent& event) {
  if (keep_one()) put_event("updating", event, node_of(event.cell));
}

void PosthocTrace::close_expanded() {
  if (!expanded_) return;
  const Cell cell = *expanded_;
  expanded_.reset();
  if (keep_one()) put_event("closing", cell, node_of(cell).id);
}

std::string PosthocTrace::finish(const Path& path) {
  close_expanded();
  if (!path.empty()) {
    const Cell end = path.cells().back();
    put_event("end", end, node_of(end).id);
    put_parent(node_of(end));
  }
  return text_.finish();
}

void PosthocTrace::put_event(std::string_view type, Cell cell, std::uint64_t id) {
  text_.begin_event(type, std::to_string(id));
  text_.put("x", static_cast<std::uint64_t>(cell.x));
  text_.put("y", static_cast<std::uint64_t>(y_up_ ? height_ - 1 - cell.y : cell.y));
}

void PosthocTrace::put_event(std::string_view type, const SearchEvent& event, Node& node) {
  node.parent.reset();
  if (event.parent) {
    const auto parent = nodes_.find(number(*event.parent));
    if (parent != nodes_.end()) node.parent = parent->second.id;
  }
  put_event(type, event.cell, node.id);
  put_parent(node);
  text_.put("f", event.f);
  text_.put("g", event.g);
  text_.put("h", event.h);
}

void PosthocTrace::put_parent(const Node& node) {
  if (node.parent) {
    text_.put("pId", *node.parent);
  } else {
    text_.put("pId", std::string_view("null"));
  }
}

}  // namespace wend
