// FreeSpace.cost_matrix() and FreeSpace.tour().

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/space.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/tour/plan_tour.hpp"
#include "wend/tour/stop_costs.hpp"
#include "wend/tour/tour_path.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

PlannerSpec planner_of(const std::string& name, const nb::dict& options) {
  PlannerSpec planner{name, {}};
  for (const auto [key, value] : options) {
    planner.options.emplace_back(nb::cast<std::string>(key), nb::cast<std::string>(value));
  }
  return planner;
}

std::vector<MapPose> stops_of(const nb::list& points) {
  std::vector<MapPose> stops;
  for (std::size_t i = 0; i < points.size(); ++i) {
    stops.push_back(coordinates_of(points[i], "points").pose());
  }
  return stops;
}

auto cost_matrix(const Space& space, const nb::list& points, const std::string& planner,
                 const nb::dict& options, unsigned threads) {
  const std::vector<MapPose> stops = stops_of(points);
  const Session::View view = space.view();
  Interrupts interrupts;
  ThreadWorkers workers(threads);
  StopCostOptions asked{planner_of(planner, options), {}, &workers};
  asked.limits.cancel = &interrupts.cancelled();
  Expected<StopCosts, Error> costs;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] { costs = stop_costs(space.session(), view, stops, asked); });
  }
  interrupts.throw_if_interrupted();
  const CostMatrix found = value_or_throw(std::move(costs)).costs;
  const auto size = static_cast<std::size_t>(found.size());
  const auto values = found.values();
  return owned_array<double, 2>(std::vector<double>(values.begin(), values.end()), {size, size});
}

using Pairs = std::vector<std::pair<int, int>>;

std::vector<StopPair> pairs_of(const Pairs& pairs) {
  std::vector<StopPair> all;
  for (const auto& [first, second] : pairs) all.push_back({first, second});
  return all;
}

/// (order, cost, bound, status, legs, points of the path in metres)
nb::tuple tour(const Space& space, const nb::list& points, const std::string& planner,
               const nb::dict& options, TourOptions asked, std::optional<double> time_limit) {
  const std::vector<MapPose> stops = stops_of(points);
  const Session::View view = space.view();
  Interrupts interrupts;
  OneWorker worker;
  StopCostOptions ways{planner_of(planner, options), {}, &worker};
  ways.limits.cancel = &interrupts.cancelled();
  if (time_limit) ways.limits.seconds = *time_limit;
  Expected<Tour, Error> found;
  Expected<TourPath, Error> way;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      const Deadline deadline(ways.limits);
      const auto costs = stop_costs(space.session(), view, stops, ways);
      if (!costs) {
        found = Unexpected<Error>(costs.error());
        return;
      }
      if (!costs->cut_off.empty()) {
        found = failure(Status::unreachable, cut_off_text(*costs));
        return;
      }
      asked.limits = deadline.left();
      found = plan_tour(costs->costs, asked);
      if (!found) return;
      ways.limits.seconds = Limits{}.seconds;  // the legs of an order that was found take little
      way = tour_path(space.session(), view, stops, found->order, asked.closed, ways);
    });
  }
  interrupts.throw_if_interrupted();
  const Tour best = value_or_throw(std::move(found));
  const TourPath path = value_or_throw(std::move(way));
  nb::list legs;
  for (const TourLeg& leg : path.legs) {
    legs.append(nb::make_tuple(leg.from, leg.to, leg.cost, leg.first, leg.last));
  }
  std::vector<double> points_m;
  for (const MapPoint& point : path.path.points_in_metres(view.space.map().frame())) {
    points_m.insert(points_m.end(), {point.x, point.y});
  }
  const std::size_t count = points_m.size() / 2;
  return nb::make_tuple(best.order, best.cost, best.bound, std::string(to_string(best.status)),
                        legs, owned_array<double, 2>(std::move(points_m), {count, std::size_t{2}}));
}

nb::tuple tour_of(const Space& space, const nb::list& points, const std::string& planner,
                  const nb::dict& options, bool closed, std::optional<int> start,
                  std::optional<int> end, const Pairs& before, const Pairs& fixed,
                  std::optional<std::uint64_t> kicks, std::uint64_t seed,
                  std::optional<double> time_limit) {
  TourOptions asked;
  asked.closed = closed;
  asked.start = start;
  asked.end = end;
  asked.before = pairs_of(before);
  asked.fixed = pairs_of(fixed);
  asked.kicks = kicks;
  asked.seed = seed;
  return tour(space, points, planner, options, std::move(asked), time_limit);
}

}  // namespace

void bind_tours(nb::class_<Space>& space) {
  space
      .def("cost_matrix", &cost_matrix, nb::arg("points"), nb::arg("planner"), nb::arg("options"),
           nb::arg("threads"))
      .def("tour", &tour_of, nb::arg("points"), nb::arg("planner"), nb::arg("options"),
           nb::arg("closed"), nb::arg("start").none(), nb::arg("end").none(), nb::arg("before"),
           nb::arg("fixed"), nb::arg("kicks").none(), nb::arg("seed"),
           nb::arg("time_limit").none());
}

}  // namespace wend::python
