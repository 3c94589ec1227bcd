#include "lab/wasm/answers.hpp"

#include "lab/wasm/cells.hpp"
#include "lab/wasm/json.hpp"
#include "wend/session/shift_text.hpp"
#include "wend/session/units.hpp"

namespace wend::lab {
namespace {

void write(Json& json, const SearchMetrics& metrics, double seconds, std::uint32_t steps) {
  json.field("expanded", metrics.expanded)
      .field("generated", metrics.generated)
      .field("maxFrontier", metrics.max_frontier)
      .field("seconds", seconds)
      .field("steps", steps);
}

/// A length in metres, and as texts say it.
void write_length(Json& json, std::string_view name, double metres, const Units& units) {
  json.key(name)
      .object()
      .field("metres", metres)
      .field("text", units.length(metres / units.frame().resolution))
      .end_object();
}

/// What the robot's planner did with the ends.
void write_notes(Json& json, const PlanAnswer& answer, const Units& units) {
  json.key("notes").array();
  for (const std::string& note : answer.notes) json.value(note);
  // A goal that no path reaches has a note already.
  const SnappingError goal =
      answer.remaining.value_or(0) > 0 ? SnappingError{} : answer.plan.goal_snapping_error;
  const std::string shifts = shifts_text(answer.plan.start_snapping_error, goal, units);
  if (!shifts.empty()) {
    json.value(answer.moves ? "the path's ends are in the middles of cells: " + shifts
                            : "the path's ends: " + shifts);
  }
  if (answer.fault) json.value(answer.fault->message);
  json.end_array();
}

}  // namespace

std::string error_text(const Error& error) {
  return Json()
      .object()
      .field("status", to_string(error.status))
      .field("error", error.message)
      .end_object()
      .text();
}

std::string failure_text(const RequestFailure& failure, std::uint32_t steps) {
  Json json;
  json.object().field("status", to_string(failure.status)).field("message", failure.message);
  write(json, failure.metrics, failure.search_seconds, steps);
  return json.end_object().text();
}

std::string plan_text(const PlanAnswer& answer, std::uint32_t steps,
                      std::span<const Solution> solutions, std::size_t lead_points) {
  const Units units(answer.space.map());
  Json json;
  json.object()
      .field("status", to_string(Status::found))
      .field("cost", answer.plan.cost)
      .field("bound", answer.plan.bound)
      .field("length", answer.path().length());
  write_notes(json, answer, units);
  if (answer.lead_out) {
    write_length(json, "wayOut", answer.lead_out->length, units);
    json.field("wayOutPoints", lead_points);
  }
  if (answer.remaining) write_length(json, "remaining", *answer.remaining, units);
  json.key("solutions").array();
  for (const Solution& solution : solutions) {
    json.object()
        .field("cost", solution.cost)
        .field("bound", solution.bound)
        .field("step", solution.step)
        .field("points", solution.points)
        .end_object();
  }
  json.end_array();
  write(json, answer.plan.metrics, answer.search_seconds, steps);
  return json.end_object().text();
}

std::string cell_text(const FreeSpace& space, Cell cell, std::uint8_t byte, const Replay& replay) {
  Json json;
  const auto blocked = space.why_blocked(cell);
  json.object()
      .field("byte", int{byte})
      .field("clearance", space.clearance(cell))
      .field("terrain", space.terrain(cell));
  if (blocked) json.field("blocked", describe(*blocked));
  if (replay.width() != 0) {
    const auto index = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(replay.width()) +
                       static_cast<std::size_t>(cell.x);
    const Replay::Known& known = replay.known()[index];
    json.field("expansion", replay.expansion()[index])
        .field("generation", replay.generation()[index])
        .field("g", double{known.g})
        .field("h", double{known.h})
        .field("f", double{known.f});
  }
  return json.end_object().text();
}

}  // namespace wend::lab
