#pragma once

// Loading motion primitives: SBPL's .mprim files, and the JSON of Nav2's state lattice planner, as its
// generator (lattice_primitives) writes it for robots of the kinds ackermann, diff and omni. A file that
// begins with '{' is JSON.
//
//   const auto primitives = wend::load_primitives("ackermann.json");
//   if (!primitives) return report(primitives.error().message);
//   const auto space = wend::make_free_space(map, {.footprint = robot, .primitives = *primitives});
//
// .mprim, whose lines come in this order; lengths in metres, headings in radians, offsets in cells:
//
//   resolution_m: 0.025
//   numberofangles: 16
//   totalnumberofprimitives: 80
//   primID: 0                     and for each primitive:
//   startangle_c: 0               a heading: 2 pi / 16 times this
//   endpose_c: 8 1 1              x, y and heading at its end
//   additionalactioncostmult: 1   the factor on its cost
//   intermediateposes: 10         from the start to the end; this many lines "x y heading" follow
//
// JSON: {"lattice_metadata": {"grid_resolution": 0.05, "heading_angles": [0, 0.46, ...]}, "primitives":
// [{"trajectory_id": 0, "start_angle_index": 0, "end_angle_index": 1, "poses": [[x, y, heading], ...]},
// ...]}. The first pose may be missing. Other keys are ignored.
//
// Strict: every number is finite and in the range that MotionPrimitives::make() says. A file has at most
// 64 MiB, and memory is proportional to its size.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/expected.hpp"
#include "wend/io/file_error.hpp"
#include "wend/robot/motion_primitives.hpp"

namespace wend {

inline constexpr std::size_t kLargestPrimitivesFile = std::size_t{64} << 20;  // bytes

/// Loads a set of primitives. Fails with invalid_file.
WEND_API Expected<MotionPrimitives, Error> load_primitives(const std::filesystem::path& file);

/// The same from a text. `name` is the name for errors.
WEND_API Expected<MotionPrimitives, Error> parse_primitives(std::string_view text,
                                                            const std::string& name);

/// The same for SBPL's format.
WEND_API Expected<MotionPrimitives, Error> parse_mprim(std::string_view text,
                                                       const std::string& name);
/// The same for Nav2's format.
WEND_API Expected<MotionPrimitives, Error> parse_lattice_json(std::string_view text,
                                                              const std::string& name);

}  // namespace wend
