#pragma once

// Families on maps that our own generators make.

#include <vector>

#include "docs/planner_page/family.hpp"

namespace wend::planner_page {

/// How much is measured: all of it, or just enough to see that the page comes out right.
enum class Effort { quick, full };

/// The map of that generator, which must be able to make it.
GridMap generated_map(std::string_view kind, int width, int height, std::uint64_t seed,
                      const OptionValues& options = {});

/// On 8 neighbours and uniform terrain, then on 4 neighbours, then on terrain.
std::vector<Family> generated_families(Effort effort);

/// A map so small that a random walk gets somewhere, and every planner there is.
Family small_family(Effort effort);

/// Start and goal in components that nothing joins, and every planner there is.
Family unreachable_family(Effort effort);

}  // namespace wend::planner_page
