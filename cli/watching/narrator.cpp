#include "cli/watching/narrator.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "cli/arguments/coordinates.hpp"
#include "wend/geometry/car_move.hpp"
#include "wend/report/plan_report.hpp"

namespace wend::cli {
namespace {

std::string place_text(Cell cell, std::optional<Heading> heading) {
  constexpr bool kYUp = false;  // there and back: letters do not depend on it
  return heading ? corner_pose_text(pose_of({cell, *heading}, kYUp), kYUp) : cell_text(cell);
}

std::string from_text(const SearchEvent& event) {
  return event.parent ? " from " + place_text(*event.parent, event.parent_heading) : "";
}

std::string reached_text(std::string_view how, const SearchEvent& event) {
  return fmt::format("  {} {}{} f={:.6g} g={:.6g} h={:.6g}\n", how,
                     place_text(event.cell, event.heading), from_text(event), event.f, event.g,
                     event.h);
}

}  // namespace

void tell(const std::string& lines) { std::fwrite(lines.data(), 1, lines.size(), stderr); }

void Narrator::on_generate(const SearchEvent& event) { tell(reached_text("generate", event)); }

void Narrator::on_expand(const SearchEvent& event) { tell("expand " + event_text(event) + "\n"); }

void Narrator::on_relax(const SearchEvent& event) { tell(reached_text("relax", event)); }

std::string event_text(const SearchEvent& event) {
  return fmt::format("{} f={:.6g} g={:.6g} h={:.6g}", place_text(event.cell, event.heading),
                     event.f, event.g, event.h);
}

}  // namespace wend::cli
