#include "wend/control/joining.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

std::vector<Candidate> candidates_on(const Route& route, const MapPose& pose) {
  std::vector<Candidate> candidates;
  for (std::size_t leg = 0; leg < route.legs().size(); ++leg) {
    const auto points = route.legs()[leg].line.points();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      candidates.push_back(candidate_on(route, leg, i, pose));
    }
  }
  return candidates;
}

/// The distance of the nearest place that can be reached; it asks about so many only.
std::optional<double> nearest_free(const std::vector<Candidate>& candidates, const MapPose& pose,
                                   const JoiningOptions& options) {
  constexpr std::size_t kMostAsked = 256;
  std::vector<const Candidate*> near;
  for (const Candidate& candidate : candidates) {
    if (candidate.place.distance <= options.within) near.push_back(&candidate);
  }
  const std::size_t asked = std::min(near.size(), kMostAsked);
  std::ranges::partial_sort(near, near.begin() + static_cast<std::ptrdiff_t>(asked), {},
                            [](const Candidate* one) { return one->place.distance; });
  for (std::size_t i = 0; i < asked; ++i) {
    if (!options.can_reach || options.can_reach(pose, near[i]->point)) {
      return near[i]->place.distance;
    }
  }
  return std::nullopt;
}

/// Of each visit, a stretch of a leg no farther than `most`, the nearest place that is not nearer than `least`: what
/// is nearer cannot be reached.
std::vector<Candidate> visits_of(const std::vector<Candidate>& candidates, double least,
                                 double most) {
  std::vector<Candidate> visits;
  bool open = false;
  for (const Candidate& candidate : candidates) {
    const double distance = candidate.place.distance;
    if (distance > most) open = false;
    if (distance >= least && distance <= most) {
      if (!open) {
        visits.push_back(candidate);
      } else if (distance < visits.back().place.distance) {
        visits.back() = candidate;
      }
      open = true;
    }
    if (candidate.last || candidate.end > most) open = false;
  }
  return visits;
}

}  // namespace

std::optional<OnRoute> place_to_join(const Route& route, const MapPose& pose,
                                     const JoiningOptions& options) {
  const std::vector<Candidate> candidates = candidates_on(route, pose);
  const auto nearest = nearest_free(candidates, pose, options);
  if (!nearest) return std::nullopt;
  std::vector<Candidate> visits =
      visits_of(candidates, *nearest, std::min(*nearest + options.tie, options.within));
  std::erase_if(visits, [&](const Candidate& visit) {
    return options.can_reach && !options.can_reach(pose, visit.point);
  });
  if (visits.empty()) return std::nullopt;
  const bool at_start = visits.front().place.leg == 0 && visits.front().place.along <= options.tie;
  const auto leading = std::ranges::find(visits, true, &Candidate::leads);
  if (at_start || leading == visits.end()) return visits.front().place;
  return leading->place;
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
