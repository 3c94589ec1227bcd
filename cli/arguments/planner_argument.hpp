#pragma once

// --planner and --index: planners by name, each with options ("astar", "astar:weight=2,bfs"), and the index
// that a planner is given or that is built now.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/workers.hpp"
#include "wend/index/file/index_bytes.hpp"
#include "wend/io/files.hpp"
#include "wend/planner/planner.hpp"
#include "wend/planner/planner_info.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/plan_report.hpp"
#include "wend/robot/free_space.hpp"

namespace wend {

class Session;

namespace cli {

/// The planners of a list. Throws InputError for one that does not exist and for text that is not an
/// option.
std::vector<PlannerSpec> parse_planners(const std::string& text);

/// The same for a list of exactly one planner.
PlannerSpec parse_planner(const std::string& text);

const PlannerInfo& info_of(const PlannerSpec& planner);

/// Has a planner or smoother an option of that name?
bool has_option(const std::vector<OptionInfo>& options, std::string_view name);

/// An index that need not be built.
struct GivenIndex {
  std::string file;
  IndexHeader header;
  IndexBytes bytes;
};

/// Throws InputError if the file cannot be read. If it is damaged or not an index, the error says what
/// is wrong.
Expected<GivenIndex, Error> read_given_index(const std::string& file);

/// Builds with a progress bar.
Expected<IndexBytes, Error> build_index(const PlannerInfo& planner, const FreeSpace& space,
                                        Workers& workers);

/// "hub_labels or euclidean_labels": the planners that can plan on an index.
std::string planners_with_index();

/// An index that was given with --index, or what is wrong with it.
using IndexArgument = std::optional<Expected<GivenIndex, Error>>;

/// Gives a session's planners of this name the index that they need: the given one, or one that is built
/// now, before the deadline; sets the time of that. Returns whether it was built.
Expected<bool, Error> provide_index(Session& session, const PlannerSpec& planner,
                                    const IndexArgument& given, WorkTimes& times,
                                    const Deadline& deadline = {});

}  // namespace cli
}  // namespace wend
