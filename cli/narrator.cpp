#include "narrator.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "coordinates.hpp"

namespace wend::cli {
namespace {

void tell(const std::string& line) { std::fwrite(line.data(), 1, line.size(), stderr); }

std::string from_text(const SearchEvent& event) {
  return event.parent ? " from " + cell_text(*event.parent) : "";
}

std::string reached_text(std::string_view how, const SearchEvent& event) {
  return fmt::format("  {} {}{} f={:.6g} g={:.6g} h={:.6g}\n", how, cell_text(event.cell),
                     from_text(event), event.f, event.g, event.h);
}

}  // namespace

void Narrator::on_generate(const SearchEvent& event) { tell(reached_text("generate", event)); }

void Narrator::on_expand(const SearchEvent& event) { tell("expand " + event_text(event) + "\n"); }

void Narrator::on_relax(const SearchEvent& event) { tell(reached_text("relax", event)); }

std::string event_text(const SearchEvent& event) {
  return fmt::format("{} f={:.6g} g={:.6g} h={:.6g}", cell_text(event.cell), event.f, event.g,
                     event.h);
}

}  // namespace wend::cli
