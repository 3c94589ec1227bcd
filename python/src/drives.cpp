// _core.Space: why there is no drive.

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <string>
#include <utility>

#include "python/src/arrays.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/plan.hpp"
#include "python/src/space.hpp"
#include "wend/analysis/no_drive.hpp"
#include "wend/base/options.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

Query query_between(const Frame& frame, nb::handle start, nb::handle goal) {
  const Coordinates from = coordinates_of(start, "start");
  const Coordinates to = coordinates_of(goal, "goal");
  Query query{frame.to_grid(from.pose()), {}};
  const Pose at = frame.to_grid(to.pose());
  query.goals.push_back(to.has_heading ? Goal(at) : Goal(at.point()));
  return query;
}

nb::tuple explained_drive(const Space& space, nb::handle start, nb::handle goal,
                          const nb::dict& options) {
  const FreeSpace free = space.view().space;
  const Frame& frame = free.map().frame();
  Query query = query_between(frame, start, goal);
  const auto planner = value_or_throw(parse_options<HybridAStarOptions>(options_of(options)));
  Interrupts interrupts;
  query.limits.cancel = &interrupts.cancelled();
  std::optional<Expected<NoDrive, Error>> answer;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] { answer = explain_no_drive(free, query, planner); });
  }
  interrupts.throw_if_interrupted();
  const NoDrive why = value_or_throw(*std::move(answer));
  const Explainer explainer(free, Units(free.map()), {}, hints());
  std::optional<double> radius;
  nb::object narrowest = nb::none();
  if (why.widest) {
    radius = why.widest->radius * frame.resolution;
    const MapPoint place = frame.to_metres(why.widest->narrowest);
    narrowest = nb::make_tuple(place.x, place.y);
  }
  return nb::make_tuple(explainer.explain(why), why.drive_exists(), why.footprint_scale,
                        why.turning_radius, why.reverse_helps, narrowest, radius);
}

}  // namespace

void bind_drives(nb::class_<Space>& space) {
  space.def("explain_drive", &explained_drive, nb::arg("start").none(), nb::arg("goal").none(),
            nb::arg("options"));
}

}  // namespace wend::python
