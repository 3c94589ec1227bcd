#include "wend/control/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "wend/base/options.hpp"
#include "wend/base/parse.hpp"
#include "wend/base/random.hpp"
#include "wend/geometry/angle.hpp"
#include "wend/geometry/trigonometry.hpp"
#include "wend/path/lead_out.hpp"
#include "wend/robot/sweep/fits_along.hpp"

namespace wend {
namespace {

/// To centimetres, for messages.
double rounded(double metres) { return std::round(metres * 100) / 100; }
double rounded_up(double metres) { return std::ceil(metres * 100) / 100; }

/// In grid coordinates. Of what goes round more than once: one round, which is all that matters to where it passes.
Segment to_grid(const MapSegment& way, const Frame& frame) {
  const double rounds = std::abs(way.turn) / (2 * kPi);
  const double share = rounds > 1 ? 1 / rounds : 1;
  return {frame.to_grid(way.from), share * way.length / frame.resolution, share * way.turn,
          way.course};
}

/// Moves a robot along segments and counts how often it runs into obstacles.
class CollisionCounter {
 public:
  /// A robot that does not fit at `start` may drive `escape` metres as long as it does not go deeper.
  CollisionCounter(const FreeSpace& space, const Pose& start, double escape)
      : space_(space), escape_(escape) {
    if (escape > 0 && !space.fits(start)) leaving_.emplace(space, start, kLeavingRounding);
  }

  /// Sweeps a segment: how much of it is free, 0 to 1, if it runs into something there; nothing if it does not, or has
  /// already.
  std::optional<double> sweep(const MapSegment& way) {
    const Segment in_grid = to_grid(way, space_.map().frame());
    if (leaves(in_grid)) return std::nullopt;
    const bool was_free = free_;
    free_ = is_free(in_grid);
    if (free_ || !was_free) return std::nullopt;
    const double share = free_share(in_grid);
    if (count_++ == 0) first_ = pose_on(in_grid, share).point();
    return share;
  }

  std::uint64_t count() const { return count_; }
  std::optional<Point> first() const { return first_; }

 private:
  // Cells: a robot does not keep exactly to its path.
  static constexpr double kLeavingRounding = 0.02;

  /// Is the segment one of the way out?
  bool leaves(const Segment& way) {
    if (!leaving_) return false;
    escape_ -= std::abs(way.length) * space_.map().frame().resolution;
    const bool goes_on =
        escape_ >= -kLeavingRounding * space_.map().frame().resolution && leaving_->go_along(way);
    if (!goes_on || !leaving_->overlaps()) leaving_.reset();
    return goes_on;
  }

  /// Arcs of robots on wheels are swept exactly.
  bool is_free(const Segment& way) const {
    return way.course == 0 && way.length != 0 ? fits_along(space_, way_of_base(way))
                                              : fits_along(space_, way);
  }

  /// By bisection: free, or 0.
  double free_share(const Segment& way) const {
    constexpr int kHalvings = 30;
    double low = 0;
    double high = 1;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (is_free(beginning_of(way, middle)) ? low : high) = middle;
    }
    return low;
  }

  const FreeSpace& space_;
  double escape_;                      // metres that are left for the way out
  std::optional<DepthWatch> leaving_;  // until the robot fits
  bool free_ = true;
  std::uint64_t count_ = 0;
  std::optional<Point> first_;
};

/// Commands on their way to the wheels.
class Delay {
 public:
  Delay(double latency, double period)
      : periods_(static_cast<std::size_t>(latency / period + kWhole)),
        rest_(std::max(latency - static_cast<double>(periods_) * period, 0.0)),
        commands_(periods_ + 2) {}

  /// How long into a period the command before the one that is due is still in effect.
  double rest() const { return rest_; }

  void send(const Velocity& command) {
    newest_ = (newest_ + 1) % commands_.size();
    commands_[newest_] = command;
  }
  /// Will the wheels get another command than to stand?
  bool any_on_its_way() const {
    for (std::size_t count = 0; count <= periods_; ++count) {
      if (sent_before(count) != Velocity{}) return true;
    }
    return false;
  }

  const Velocity& due() const { return sent_before(periods_); }
  const Velocity& due_before() const { return sent_before(periods_ + 1); }

 private:
  const Velocity& sent_before(std::size_t count) const {
    return commands_[(newest_ + commands_.size() - count) % commands_.size()];
  }

  static constexpr double kWhole = 1e-9;  // so near below a whole number of periods is one

  std::size_t periods_;
  double rest_;
  std::vector<Velocity> commands_;  // a ring, all standing at first
  std::size_t newest_ = 0;
};

constexpr std::size_t kMostCommands = 1'000'000;

/// Finds the first option that is not in its range.
class RangeCheck {
 public:
  void operator()(const OptionText& text, double value, OptionRange range) {
    if (fault_ || (value >= range.least && value <= range.greatest)) return;
    const std::string name(text.name);
    fault_ = Error{Status::invalid_option,
                   name + " must be from " + format_number(range.least) + " to " +
                       format_number(range.greatest),
                   name};
  }
  void operator()(const OptionText& text, std::int64_t value, OptionRange range) {
    (*this)(text, static_cast<double>(value), range);
  }
  template <class Choice>
  void operator()(const OptionText& /*text*/, Choice /*value*/) {}

  const std::optional<Error>& fault() const { return fault_; }

 private:
  std::optional<Error> fault_;
};

template <class Options>
std::optional<Error> fault_of(const Options& options) {
  RangeCheck check;
  Options::fields(options, check);
  return check.fault();
}

class Simulation {
 public:
  Simulation(const FreeSpace& space, const Path& path, Controller& controller,
             const MotionModel& model, const SimulationOptions& options,
             const FollowerOptions& follower)
      : frame_(space.map().frame()),
        route_(path, frame_, options.closed),
        model_(model),
        options_(options),
        period_(1 / options.rate),
        follower_(controller, model.limits, adapted(follower, model)),
        tolerances_(follower),
        collisions_(space, frame_.to_grid(route_.start()), options.escape),
        random_(static_cast<std::uint64_t>(options.seed)),
        delay_(options.latency, period_) {
    robot_.pose = route_.start();
    follower_.follow(route_);
  }

  Drive run() {
    const double limit = time_limit();
    std::optional<DriveOutcome> outcome;
    while (!outcome) {
      const FollowerStep step = follower_.step(measured(), period_);
      note();
      outcome = outcome_of(step.state);
      if (!outcome && (drive_.time >= limit || drive_.samples.size() >= kMostCommands)) {
        const bool failed =
            step.state != FollowerState::driving && step.state != FollowerState::reached;
        outcome = failed ? ended_in(step.state) : DriveOutcome::time;
      }
      if (!outcome && move(step.command)) outcome = DriveOutcome::collision;
      if (outcome == DriveOutcome::collision) note();
    }
    drive_.outcome = *outcome;
    finish();
    return std::move(drive_);
  }

 private:
  static FollowerOptions adapted(FollowerOptions options, const MotionModel& model) {
    options.turns_in_place = model.turning_radius() == 0;
    options.moves_aside = model.drivetrain == Drivetrain::omni;
    return options;
  }

  double time_limit() const {
    if (options_.time_limit > 0) return options_.time_limit;
    constexpr double kSlack = 60;
    constexpr double kTimes = 10;
    return kSlack + kTimes * route_.length() / model_.limits.speed;
  }

  /// Once the robot stands, after the commands that were still on their way.
  std::optional<DriveOutcome> outcome_of(FollowerState state) const {
    const bool moves = robot_.velocity != Velocity{} || delay_.any_on_its_way();
    if (state == FollowerState::driving || moves) return std::nullopt;
    return ended_in(state);
  }

  DriveOutcome ended_in(FollowerState state) const {
    switch (state) {
      case FollowerState::stuck:
        return DriveOutcome::stuck;
      case FollowerState::off_path:
        return DriveOutcome::off_path;
      case FollowerState::reached:
        return is_at_goal() ? DriveOutcome::reached : DriveOutcome::missed;
      case FollowerState::driving:
      case FollowerState::invalid:
        break;
    }
    return DriveOutcome::stuck;
  }

  /// By its true pose.
  bool is_at_goal() const {
    const MapPose& end = route_.end();
    const double turned = std::abs(normalized_angle(end.heading - robot_.pose.heading));
    const double tolerance = route_.final_heading() ? tolerances_.heading_tolerance : 0;
    return distance(robot_.pose.point(), end.point()) <= tolerances_.goal_tolerance &&
           (tolerance == 0 || turned <= tolerance);
  }

  MapPose measured() {
    MapPose pose = robot_.pose;
    if (options_.position_noise > 0) {
      pose.x += options_.position_noise * random_.gaussian();
      pose.y += options_.position_noise * random_.gaussian();
    }
    if (options_.heading_noise > 0) pose.heading += options_.heading_noise * random_.gaussian();
    return pose;
  }

  /// One period. True if the robot ran into something and shall stop there.
  bool move(const Velocity& command) {
    delay_.send(command);
    Velocity errors{1, 1};
    if (options_.actuation_noise > 0) {
      errors.linear += options_.actuation_noise * random_.gaussian();
      errors.angular += options_.actuation_noise * random_.gaussian();
    }
    if (delay_.rest() > 0 && move(delay_.due_before(), errors, delay_.rest())) return true;
    return move(delay_.due(), errors, period_ - delay_.rest());
  }

  bool move(const Velocity& command, const Velocity& errors, double seconds) {
    wheels_ = drive(model_, {robot_.pose, wheels_}, command, seconds).to.velocity;
    const Velocity velocity{wheels_.linear * errors.linear, wheels_.angular * errors.angular,
                            wheels_.lateral * errors.linear};
    const Step step = hold(robot_.pose, velocity, seconds);
    const std::optional<double> free =
        collisions_.sweep({robot_.pose, step.arc.length, velocity.angular * seconds, step.course});
    if (free && options_.stop_at_collision) {
      add(hold(robot_.pose, velocity, *free * seconds), *free * seconds);
      return true;
    }
    add(step, seconds);
    return false;
  }

  void add(const Step& step, double seconds) {
    robot_ = step.to;
    drive_.time += seconds;
    drive_.distance += std::abs(step.arc.length);
    drive_.turned += std::abs(robot_.velocity.angular) * seconds;
    watch_swings();
  }

  void watch_swings() {
    constexpr double kFast = 0.2;  // of the greatest turn rate
    if (std::abs(robot_.velocity.angular) < kFast * model_.limits.turn_rate) return;
    const bool left = robot_.velocity.angular > 0;
    if (turned_left_ && *turned_left_ != left) ++drive_.swings;
    turned_left_ = left;
  }

  /// A sample of the true robot beside the route, near where the follower thinks that it is.
  void note() {
    const RouteLeg& leg = route_.legs()[follower_.leg()];
    constexpr double kDeviations = 4;
    const double around = kDeviations * options_.position_noise;
    const double along = follower_.along_leg();
    const OnMapPolyline place =
        leg.line.nearest(robot_.pose.point(), along - around, along + around);
    const double heading = leg.line.heading_at(place.along, tolerances_.heading_window);
    const double to_x = robot_.pose.x - place.point.x;
    const double to_y = robot_.pose.y - place.point.y;
    const auto [sine, cosine] = sine_and_cosine(heading);
    const double left = cosine * to_y - sine * to_x;
    const double turned = seen_on(leg, {0, 0, heading}).heading;
    drive_.samples.push_back({drive_.time, frame_.to_grid(robot_.pose), robot_.velocity,
                              normalized_angle(turned - robot_.pose.heading),
                              std::copysign(place.distance, left)});
  }

  void finish() {
    double squares = 0;
    for (const DriveSample& sample : drive_.samples) {
      squares += sample.cross_track * sample.cross_track;
      drive_.cross_track_largest =
          std::max(drive_.cross_track_largest, std::abs(sample.cross_track));
    }
    drive_.cross_track_rms = std::sqrt(squares / static_cast<double>(drive_.samples.size()));
    drive_.final_error = distance(robot_.pose.point(), route_.end().point());
    drive_.final_heading_error = normalized_angle(route_.end().heading - robot_.pose.heading);
    drive_.collisions = collisions_.count();
    drive_.first_collision = collisions_.first();
  }

  const Frame& frame_;
  Route route_;
  MotionModel model_;
  SimulationOptions options_;
  double period_;
  Follower follower_;
  FollowerOptions tolerances_;
  CollisionCounter collisions_;
  Random random_;
  Delay delay_;

  RobotState robot_;
  Velocity wheels_;                  // as the robot means it; errors come on top
  std::optional<bool> turned_left_;  // when it last turned fast
  Drive drive_;
};

}  // namespace

bool Drive::oscillates() const { return static_cast<double>(swings) > std::max(time, 1.0); }

std::string_view describe(DriveOutcome outcome) {
  constexpr std::array<Choice<DriveOutcome>, 7> kTexts{
      {{"reached the goal", DriveOutcome::reached},
       {"got stuck", DriveOutcome::stuck},
       {"left the path", DriveOutcome::off_path},
       {"ran into an obstacle", DriveOutcome::collision},
       {"ran out of time", DriveOutcome::time},
       {"stopped beside the goal", DriveOutcome::missed},
       {"was refused", DriveOutcome::refused}}};
  return choice_name(outcome, kTexts);
}

std::string_view default_controller(const Path& path) {
  return path.driven() ? "stanley" : "pure_pursuit";
}

std::optional<Error> why_undrivable(const Path& path, const Frame& frame,
                                    const MotionModel& model) {
  const auto refused = [](std::string message) {
    return Error{Status::unsupported_query, std::move(message), "path"};
  };
  if (path.empty()) return refused("the path is empty");
  if (!Route(path, frame).valid()) {
    return refused("the path has a number that is not finite, is farther than " +
                   format_number(Route::kFarthest) +
                   " m from the origin, or has a heading beyond " +
                   format_number(Route::kLargestHeading) + " rad");
  }
  const auto at = [&](const Pose& pose) {
    const MapPoint point = frame.to_metres(pose).point();
    return "(" + format_number(rounded(point.x)) + "," + format_number(rounded(point.y)) + ") m";
  };
  const auto aside = model.drivetrain == Drivetrain::omni ? std::nullopt : first_step_aside(path);
  if (aside) {
    return refused("the path steps to a side of the robot at " + at(*aside) +
                   ", which a robot on wheels cannot drive");
  }
  if (model.turning_radius() == 0) return std::nullopt;
  if (const auto turn = first_turn_in_place(path)) {
    return refused("the path turns in place at " + at(*turn) + ", which a bicycle cannot drive");
  }
  const double radius = model.turning_radius() / frame.resolution;
  if (const auto bend = first_bend_tighter_than(radius, path)) {
    return refused("the path bends at " + at(*bend) +
                   " tighter than the bicycle can steer, whose radius is " +
                   format_number(rounded_up(model.turning_radius())) + " m");
  }
  return std::nullopt;
}

Drive simulate(const FreeSpace& space, const Path& path, Controller& controller,
               const MotionModel& model, const SimulationOptions& options,
               const FollowerOptions& follower) {
  auto fault = why_undrivable(path, space.map().frame(), model);
  if (!fault) fault = fault_of(model);
  if (!fault) fault = fault_of(options);
  if (!fault) fault = fault_of(follower);
  if (fault) {
    Drive drive;
    drive.outcome = DriveOutcome::refused;
    drive.refusal = std::move(fault->message);
    return drive;
  }
  return Simulation(space, path, controller, model, options, follower).run();
}

}  // namespace wend
