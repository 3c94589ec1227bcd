#include "wend/control/joining.hpp"

#include <algorithm>
#include <utility>

#include "wend/geometry/trigonometry.hpp"

namespace wend {
namespace {

/// The place of one line of the route that is nearest to the robot.
struct Candidate {
  OnRoute place;
  MapPoint point;
  bool leads = false;  // the way the robot faces
  double end = 0;      // m, how far the line's end is
  bool last = false;   // of its leg
};

Candidate candidate_on(const Route& route, std::size_t leg, std::size_t piece,
                       const MapPose& pose) {
  const MapPolyline& line = route.legs()[leg].line;
  const MapPoint a = line.points()[piece];
  const MapPoint b = line.points()[piece + 1];
  const double length = line.along()[piece + 1] - line.along()[piece];
  const double dx = (b.x - a.x) / length;
  const double dy = (b.y - a.y) / length;
  const double along = std::clamp((pose.x - a.x) * dx + (pose.y - a.y) * dy, 0.0, length);
  const MapPoint point{a.x + along * dx, a.y + along * dy};
  const auto [sine, cosine] = sine_and_cosine(shown_on(route.legs()[leg], pose).heading);
  return {.place = {leg, line.along()[piece] + along, distance(point, pose.point())},
          .point = point,
          .leads = cosine * dx + sine * dy >= 0,
          .end = distance(b, pose.point()),
          .last = piece + 2 == line.points().size()};
}

/// Calls each(candidate) for every line of the route, in driving order.
template <class Each>
void for_each_candidate(const Route& route, const MapPose& pose, Each&& each) {
  for (std::size_t leg = 0; leg < route.legs().size(); ++leg) {
    const std::size_t points = route.legs()[leg].line.points().size();
    for (std::size_t i = 0; i + 1 < points; ++i) each(candidate_on(route, leg, i, pose));
  }
}

/// The distance of the nearest place that can be reached. It asks about so many places only, the nearest first, and
/// takes no memory.
std::optional<double> nearest_free(const Route& route, const MapPose& pose,
                                   const JoiningOptions& options) {
  constexpr int kMostAsked = 256;
  double asked = -1;  // how far the place was that was asked about last
  for (int count = 0; count < kMostAsked; ++count) {
    std::optional<Candidate> next;
    for_each_candidate(route, pose, [&](const Candidate& candidate) {
      const double distance = candidate.place.distance;
      if (distance <= asked || distance > options.within) return;
      if (!next || distance < next->place.distance) next = candidate;
    });
    if (!next) return std::nullopt;
    asked = next->place.distance;
    if (!options.can_reach || options.can_reach(pose, next->point)) return asked;
  }
  return std::nullopt;
}

/// Chooses among visits: stretches of a leg no farther than `most`, each with its nearest place that is not nearer than
/// `least`: what is nearer cannot be reached.
class VisitChoice {
 public:
  VisitChoice(const MapPose& pose, const JoiningOptions& options, double least)
      : pose_(pose),
        options_(options),
        least_(least),
        most_(std::min(least + options.tie, options.within)) {}

  void take(const Candidate& candidate) {
    const double distance = candidate.place.distance;
    if (distance > most_) end_visit();
    if (distance >= least_ && distance <= most_ && (!visit_ || distance < visit_->place.distance)) {
      visit_ = candidate;
    }
    if (candidate.last || candidate.end > most_) end_visit();
  }

  std::optional<OnRoute> best() {
    end_visit();
    if (!first_) return std::nullopt;
    const bool at_start = first_->place.leg == 0 && first_->place.along <= options_.tie;
    return at_start || !leading_ ? first_->place : leading_->place;
  }

 private:
  void end_visit() {
    const std::optional<Candidate> visit = std::exchange(visit_, std::nullopt);
    if (!visit || (options_.can_reach && !options_.can_reach(pose_, visit->point))) return;
    if (!first_) first_ = visit;
    if (!leading_ && visit->leads) leading_ = visit;
  }

  const MapPose& pose_;
  const JoiningOptions& options_;
  double least_;
  double most_;
  std::optional<Candidate> visit_;  // so far
  std::optional<Candidate> first_;
  std::optional<Candidate> leading_;
};

}  // namespace

std::optional<OnRoute> place_to_join(const Route& route, const MapPose& pose,
                                     const JoiningOptions& options) {
  const auto nearest = nearest_free(route, pose, options);
  if (!nearest) return std::nullopt;
  VisitChoice choice(pose, options, *nearest);
  for_each_candidate(route, pose, [&](const Candidate& candidate) { choice.take(candidate); });
  return choice.best();
}

bool same_route(const Route& a, const Route& b) {
  const auto same_point = [](MapPoint p, MapPoint q) {
    return distance(p, q) <= Route::kSamePlace;
  };
  const auto same_leg = [&](const RouteLeg& p, const RouteLeg& q) {
    return p.reverse == q.reverse && p.turn_first == q.turn_first && p.course == q.course &&
           p.line.closed() == q.line.closed() &&
           std::ranges::equal(p.line.points(), q.line.points(), same_point);
  };
  return a.valid() == b.valid() && a.final_heading() == b.final_heading() &&
         std::ranges::equal(a.legs(), b.legs(), same_leg);
}

}  // namespace wend
