#include "wend/analysis/no_drive.hpp"

#include <functional>

#include "wend/planner/planner_options.hpp"

namespace wend {
namespace {

// Shares of the asked footprint or turning radius that are tried.
constexpr int kWhole = 128;
constexpr int kLeast = kWhole / 16;

bool is_about_ends(Status status) {
  return status == Status::start_outside || status == Status::goal_outside ||
         status == Status::unsupported_query;
}

bool is_limit_of_search(Status status) {
  return status == Status::expansion_limit || status == Status::time_limit ||
         status == Status::cancelled;
}

bool is_blocked(Status status) {
  return status == Status::start_blocked || status == Status::goal_blocked;
}

bool is_car(const HybridAStarOptions& options) {
  return options.motion_model == DriveKind::reeds_shepp ||
         options.motion_model == DriveKind::dubins;
}

/// One query, planned for changed robots.
class DriveTrials {
 public:
  DriveTrials(const FreeSpace& space, const Query& query, const HybridAStarOptions& options,
              std::uint64_t expansions)
      : space_(space), query_(query), options_(options), asked_limits_(query.limits) {
    query_.observer = nullptr;
    query_.limits = {};
    query_.limits.expansions = expansions;
    query_.limits.cancel = query.limits.cancel;
  }

  std::uint64_t expanded() const { return expanded_; }
  bool cancelled() const { return query_.limits.cancel != nullptr && *query_.limits.cancel; }

  /// Plans as asked.
  Expected<NoDrive, Error> ask() {
    NoDrive why;
    auto planner = make_planner(space_, options_);
    if (!planner) return Unexpected<Error>(std::move(planner.error()));
    Query asked = query_;
    asked.limits = asked_limits_;
    why.status = plan(**planner, asked);
    if (why.status == Status::found) return why;
    why.failure = (*planner)->failure(asked, why.status);
    why.certain = !is_limit_of_search(why.status) && expanded_ == 0;
    return why;
  }

  std::optional<double> largest_scale() {
    if (space_.is_point()) return std::nullopt;
    return largest_share([this](double share) {
      Robot robot = space_.robot();
      robot.footprint = robot.footprint.scaled(share);
      const auto space = make_free_space(space_.obstacles(), std::move(robot));
      return space && finds(*space, options_);
    });
  }

  std::optional<double> largest_radius() {
    const auto share = largest_share([this](double of_radius) {
      HybridAStarOptions options = options_;
      options.turning_radius *= of_radius;
      return finds(space_, options);
    });
    return share ? std::optional(*share * options_.turning_radius) : std::nullopt;
  }

  bool finds_in_reverse() {
    HybridAStarOptions options = options_;
    options.allow_reverse = true;
    if (options.motion_model == DriveKind::dubins) options.motion_model = DriveKind::reeds_shepp;
    return finds(space_, options);
  }

 private:
  Status plan(Planner& planner, const Query& query) {
    const auto found = planner.plan(query);
    expanded_ += found ? found->metrics.expanded : found.error().metrics.expanded;
    return found ? Status::found : found.error().status;
  }

  bool finds(const FreeSpace& space, const HybridAStarOptions& options) {
    const auto planner = make_planner(space, options);
    return planner && plan(**planner, query_) == Status::found;
  }

  /// The largest share of the asked value for which finds() holds, by bisection: that of 1 does not.
  std::optional<double> largest_share(const std::function<bool(double)>& finds) const {
    const auto works = [&](int parts) { return finds(static_cast<double>(parts) / kWhole); };
    if (!works(kLeast)) return std::nullopt;
    int best = kLeast;
    int too_large = kWhole;
    while (too_large - best > 1 && !cancelled()) {
      const int middle = (best + too_large) / 2;
      (works(middle) ? best : too_large) = middle;
    }
    return static_cast<double>(best) / kWhole;
  }

  const FreeSpace& space_;
  Query query_;
  HybridAStarOptions options_;
  Limits asked_limits_;
  std::uint64_t expanded_ = 0;
};

}  // namespace

Expected<NoDrive, Error> explain_no_drive(const FreeSpace& space, const Query& query,
                                          const HybridAStarOptions& options,
                                          std::uint64_t expansions) {
  DriveTrials trials(space, query, options, expansions);
  auto why = trials.ask();
  if (!why || is_about_ends(why->status)) return why;
  const auto start = cell_under(space, query.start.point());
  const auto goal = cell_under(space, query.goals.front().point);
  if (start && goal) why->widest = widest_path(space, *start, *goal);
  if (!why->drive_exists() && !trials.cancelled()) {
    why->footprint_scale = trials.largest_scale();
    const bool ends_fit = !is_blocked(why->status);
    if (ends_fit && is_car(options)) why->turning_radius = trials.largest_radius();
    const bool ahead_only = options.motion_model == DriveKind::dubins || !options.allow_reverse;
    if (ends_fit && ahead_only) why->reverse_helps = trials.finds_in_reverse();
  }
  if (trials.cancelled()) why->status = Status::cancelled;
  why->expanded = trials.expanded();
  return why;
}

}  // namespace wend
