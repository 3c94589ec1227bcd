// Plans and fields of the C interface.

#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "wend/base/registry.hpp"
#include "wend/c/boundary.hpp"
#include "wend/c/objects.hpp"
#include "wend/path/gears.hpp"
#include "wend/search/search_metrics.hpp"

wend_plan::wend_plan(const wend::PlanAnswer& answer)
    : cost(answer.plan.cost),
      bound(answer.plan.bound),
      length(answer.path().length() * answer.space.map().frame().resolution),
      metrics(answer.plan.metrics),
      lead_out(answer.lead_out.value_or(wend::LeadOut{})),
      remaining(answer.remaining.value_or(std::numeric_limits<double>::quiet_NaN())),
      start_shift(answer.start_shift()),
      goal_shift(answer.goal_shift()),
      kept(answer.kept),
      space(answer.space),
      path(answer.path()) {
  for (const wend::MapPose& pose : answer.poses()) poses.push_back({pose.x, pose.y, pose.heading});
  for (const int gear : wend::gears_of(answer.path())) gears.push_back(gear);
}

namespace wend::c {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// All metrics of a plan, lengths in metres.
std::vector<Metric> metrics_of(const PathMetrics& path, const SearchMetrics& search,
                               double resolution) {
  std::vector<Metric> metrics = wend::metrics_of(path);
  for (const Metric& metric : wend::metrics_of(search)) metrics.push_back(metric);
  for (Metric& metric : metrics) metric.value = metric.in_metres(resolution);
  return metrics;
}

const std::vector<Metric>& listed_metrics() {
  static const std::vector<Metric> listed = metrics_of(PathMetrics{}, SearchMetrics{}, 1);
  return listed;
}

/// Null beyond the list. The texts are literals, which end with a zero.
template <class Text>
const char* metric_text(std::size_t index, const Text& text) {
  const std::vector<Metric>& listed = listed_metrics();
  return index < listed.size() ? text(listed[index]).data() : nullptr;
}

Expected<double, Failure> metric_of(const wend_plan& plan, std::string_view name) {
  std::call_once(plan.measured, [&] { plan.measures = measure(plan.path, plan.space); });
  if (!plan.measures) return failed(plan.measures.error());
  const double resolution = plan.space.map().frame().resolution;
  std::vector<std::string> names;
  for (const Metric& metric : metrics_of(*plan.measures, plan.metrics, resolution)) {
    if (metric.name == name) return metric.value;
    names.emplace_back(metric.name);
  }
  return failed(Error{Status::invalid_option, unknown_name("metric", name, names)});
}

const CostToGo* costs_of(const wend_field* field) {
  return field == nullptr ? nullptr : field->field.costs.get();
}

Expected<std::unique_ptr<wend_plan>, Failure> plan_from(const wend_field& field,
                                                        const wend_pose& start) {
  const FreeSpace& space = field.space;
  const Units units(space.map());
  const Point point = space.map().frame().to_grid(MapPoint{start.x, start.y});
  const auto cell = cell_under(space, point);
  const Explainer explainer(space, units, {}, {});
  const Place place = units.place("start", point);
  if (!cell) return failed(Error{Status::start_outside, explainer.outside(place)});
  auto plan = field.field.costs->path_from(*cell);
  if (!plan && plan.error().status == Status::start_blocked) {
    return failed(Error{Status::start_blocked, explainer.blocked(place)});
  }
  if (!plan) return failed(std::move(plan.error()));
  if (space.map().frame().metric) {
    plan->start_snapping_error.distance = distance(centre_of(*cell), point);
  }
  return std::make_unique<wend_plan>(PlanAnswer{.space = space, .plan = *std::move(plan)});
}

}  // namespace
}  // namespace wend::c

using namespace wend::c;

size_t wend_plan_pose_count(const wend_plan* plan) {
  return plan == nullptr ? 0 : plan->poses.size();
}

const wend_pose* wend_plan_poses(const wend_plan* plan) {
  return plan == nullptr ? nullptr : plan->poses.data();
}

const int32_t* wend_plan_gears(const wend_plan* plan) {
  return plan == nullptr ? nullptr : plan->gears.data();
}

double wend_plan_start_shift(const wend_plan* plan) {
  return plan == nullptr ? kNoNumber : plan->start_shift;
}

double wend_plan_goal_shift(const wend_plan* plan) {
  return plan == nullptr ? kNoNumber : plan->goal_shift;
}

double wend_plan_cost(const wend_plan* plan) { return plan == nullptr ? kNoNumber : plan->cost; }

double wend_plan_bound(const wend_plan* plan) { return plan == nullptr ? kNoNumber : plan->bound; }

double wend_plan_length(const wend_plan* plan) {
  return plan == nullptr ? kNoNumber : plan->length;
}

int32_t wend_plan_kept(const wend_plan* plan) { return plan != nullptr && plan->kept ? 1 : 0; }

uint64_t wend_plan_expanded(const wend_plan* plan) {
  return plan == nullptr ? 0 : plan->metrics.expanded;
}

uint64_t wend_plan_generated(const wend_plan* plan) {
  return plan == nullptr ? 0 : plan->metrics.generated;
}

size_t wend_metric_count() { return listed_metrics().size(); }

const char* wend_metric_name(size_t index) {
  return metric_text(index, [](const wend::Metric& metric) { return metric.name; });
}

const char* wend_metric_unit(size_t index) {
  return metric_text(
      index, [](const wend::Metric& metric) { return wend::metric_unit_name(metric.unit); });
}

const char* wend_metric_help(size_t index) {
  return metric_text(index, [](const wend::Metric& metric) { return metric.help; });
}

wend_status wend_plan_metric(const wend_plan* plan, const char* name, double* value,
                             wend_error* error) {
  return guarded(error, [&]() -> wend::Expected<void, Failure> {
    if (plan == nullptr) return refused("plan is null");
    if (name == nullptr) return refused("name is null");
    if (value == nullptr) return refused("the pointer for the value is null");
    const auto metric = metric_of(*plan, name);
    if (!metric) return wend::Unexpected<Failure>(metric.error());
    *value = *metric;
    return {};
  });
}

double wend_plan_lead_out_length(const wend_plan* plan) {
  return plan == nullptr ? kNoNumber : plan->lead_out.length;
}

size_t wend_plan_lead_out_pose_count(const wend_plan* plan) {
  return plan == nullptr ? 0 : plan->lead_out.points;
}

const char* wend_plan_lead_out_reason(const wend_plan* plan) {
  return plan == nullptr ? nullptr : plan->lead_out.reason.c_str();
}

double wend_plan_remaining(const wend_plan* plan) {
  return plan == nullptr ? kNoNumber : plan->remaining;
}

void wend_plan_free(wend_plan* plan) { delete plan; }

int32_t wend_field_width(const wend_field* field) {
  return field == nullptr ? 0 : field->space.width();
}

int32_t wend_field_height(const wend_field* field) {
  return field == nullptr ? 0 : field->space.height();
}

const double* wend_field_costs(const wend_field* field) {
  const wend::CostToGo* costs = costs_of(field);
  return costs == nullptr ? nullptr : costs->costs().values().data();
}

double wend_field_cost_at(const wend_field* field, double x, double y) {
  const wend::CostToGo* costs = costs_of(field);
  if (costs == nullptr) return kNoNumber;
  const wend::Point point = field->space.map().frame().to_grid(wend::MapPoint{x, y});
  const auto cell = wend::cell_under(field->space, point);
  return cell ? costs->cost(*cell) : kInfinity;
}

uint64_t wend_field_expanded(const wend_field* field) {
  return field == nullptr ? 0 : field->field.metrics.expanded;
}

wend_status wend_field_plan(const wend_field* field, const wend_pose* start, wend_plan** plan,
                            wend_error* error) {
  return made("plan", plan, error, [&]() -> wend::Expected<std::unique_ptr<wend_plan>, Failure> {
    if (field == nullptr) return refused("field is null");
    if (start == nullptr) return refused("start is null");
    if (!is_finite(*start)) return refused("start contains NaN or infinity");
    return plan_from(*field, *start);
  });
}

void wend_field_free(wend_field* field) { delete field; }
