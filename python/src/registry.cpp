// The planners, smoothers and controllers as dictionaries, and indexes.

#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "python/src/bindings.hpp"
#include "python/src/errors.hpp"
#include "python/src/interrupts.hpp"
#include "python/src/registry.hpp"
#include "python/src/space.hpp"
#include "wend/base/registry.hpp"
#include "wend/base/thread_workers.hpp"
#include "wend/control/controller_fields.hpp"
#include "wend/io/files.hpp"
#include "wend/path/smoothing/smoother_fields.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/index_support.hpp"
#include "wend/planner/planner_fields.hpp"

namespace nb = nanobind;

namespace wend::python {
namespace {

nb::str str_of(std::string_view text) { return nb::str(text.data(), text.size()); }

nb::object object_of(std::string_view text) { return str_of(text); }
nb::object object_of(bool flag) { return nb::bool_(flag); }
nb::object object_of(double number) { return nb::float_(number); }
nb::object object_of(const std::vector<std::string>& texts) {
  nb::list list;
  for (const std::string& text : texts) list.append(str_of(text));
  return nb::tuple(list);
}
nb::object object_of(const std::vector<OptionInfo>& options);

/// A dictionary of the facts of a planner, a smoother, a controller or an option.
template <class Info>
nb::dict entry_of(const Info& info) {
  nb::dict entry;
  visit_fields(info, [&entry](std::string_view name, const auto& value) {
    entry[str_of(name == "citation" ? "paper" : name)] = object_of(value);
  });
  return entry;
}

nb::list options_of(const std::vector<OptionInfo>& options) {
  nb::list list;
  for (const OptionInfo& option : options) list.append(entry_of(option));
  return list;
}

nb::object object_of(const std::vector<OptionInfo>& options) { return options_of(options); }

template <class Info>
nb::list listed(const Registry<Info>& registry) {
  nb::list list;
  for (const Info& info : registry) list.append(entry_of(info));
  return list;
}

/// The bytes of an index, and the planner that reads them.
struct Index {
  std::string planner;
  IndexBytes bytes;
};

constexpr double kLeastProgress = 0.005;  // between two calls of Python

/// Passes the share of an index that is built on to a function of Python, or to None. It may be called on any thread
/// without the interpreter lock.
std::function<void(double)> teller_of(nb::handle tell) {
  if (tell.is_none()) return {};
  return [tell, told = -1.0](double share) mutable {
    if (share < told + kLeastProgress && share < 1) return;
    told = share;
    const nb::gil_scoped_acquire locked;
    try {
      tell(share);
    } catch (nb::python_error& error) {
      error.discard_as_unraisable(tell);
    }
  };
}

Index built_index(const Space& space, const std::string& planner, unsigned threads,
                  nb::handle tell) {
  const PlannerInfo* const info = value_or_throw(planners().named("planner", planner));
  if (!info->index_support) {
    throw_failure(Status::invalid_option, planner + " does not use an index", "planner");
  }
  const std::function<void(double)> progress = teller_of(tell);
  const FreeSpace free = space.view().space;
  Interrupts interrupts;
  Expected<IndexBytes, Error> bytes;
  {
    const nb::gil_scoped_release unlocked;
    interrupts.run([&] {
      ThreadWorkers workers(threads);
      IndexBuilding building;
      building.workers = &workers;
      building.cancel = &interrupts.cancelled();
      building.progress = progress;
      bytes = info->index_support->build(free, building);
    });
  }
  interrupts.throw_if_interrupted();
  return {planner, value_or_throw(std::move(bytes))};
}

Index opened_index(const std::filesystem::path& file) {
  const nb::gil_scoped_release unlocked;
  IndexBytes bytes = value_or_throw(open_index(file));
  auto header = read_index_header(bytes.bytes());
  if (!header) {
    header.error().message = file.string() + ": " + header.error().message;
    header.error().where = file.string();
  }
  return {std::string(value_or_throw(std::move(header)).planner_name()), std::move(bytes)};
}

}  // namespace

bool steps_from_cell_to_cell(const PlannerInfo& planner) {
  return !planner.capabilities.headings && !planner.capabilities.any_angle;
}

bool has_option(const PlannerInfo& planner, std::string_view name) {
  return std::ranges::any_of(planner.options,
                             [&](const OptionInfo& option) { return option.name == name; });
}

void bind_registry(nb::module_& module) {
  module.def("planners", [] { return listed(planners()); });
  module.def("smoothers", [] { return listed(smoothers()); });
  module.def("controllers", [] { return listed(controllers()); });
  module.def("trajectory_limits", [] { return options_of(option_schema<TrajectoryLimits>()); });

  nb::class_<Index>(module, "Index", "What a planner with an index computed for a map and a robot.")
      .def_ro("planner", &Index::planner)
      .def_prop_ro("size", [](const Index& index) { return index.bytes.size(); })
      .def("save",
           [](const Index& index, const std::filesystem::path& file) {
             const nb::gil_scoped_release unlocked;
             value_or_throw(write_index(file, index.bytes));
           })
      .def("give_to", [](const Index& index, const Space& space) {
        space.session().set_index(index.planner, index.bytes);
      });
  module.def("build_index", &built_index, nb::arg("space"), nb::arg("planner"), nb::arg("threads"),
             nb::arg("tell").none());
  module.def("open_index", &opened_index, nb::arg("file"));
}

}  // namespace wend::python
