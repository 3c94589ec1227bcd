#include "docs/planner_page/ratios.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "docs/planner_page/markdown.hpp"

namespace wend::planner_page {
namespace {

bool is_less(const OnMap& a, const OnMap& b) { return a.value < b.value; }

}  // namespace

std::string OnMap::title() const { return fmt::format("*{}*", family->title); }

std::vector<OnMap> values_of(std::span<const MeasuredFamily> families, std::string_view role,
                             Measured number) {
  std::vector<OnMap> values;
  for (const MeasuredFamily& family : families) {
    const MeasuredPlanner* const planner = family.find(role);
    if (planner != nullptr) values.push_back({&family, planner->*number});
  }
  return values;
}

std::vector<OnMap> ratios(std::span<const MeasuredFamily> families, std::string_view role,
                          std::string_view other, Measured number) {
  std::vector<OnMap> values;
  for (const MeasuredFamily& family : families) {
    const MeasuredPlanner* const a = family.find(role);
    const MeasuredPlanner* const b = family.find(other);
    if (a != nullptr && b != nullptr) values.push_back({&family, a->*number / (b->*number)});
  }
  return values;
}

const OnMap& least_of(const std::vector<OnMap>& values) {
  return *std::min_element(values.begin(), values.end(), is_less);
}

const OnMap& greatest_of(const std::vector<OnMap>& values) {
  return *std::max_element(values.begin(), values.end(), is_less);
}

std::vector<OnMap> below(const std::vector<OnMap>& values, double limit) {
  std::vector<OnMap> some;
  std::copy_if(values.begin(), values.end(), std::back_inserter(some),
               [limit](const OnMap& value) { return value.value < limit; });
  return some;
}

std::string titles(const std::vector<OnMap>& values) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const OnMap& value : values) names.push_back(value.title());
  return listed(names);
}

std::string range_of(const std::vector<OnMap>& values, std::string (*text)(double)) {
  const std::string low = text(least_of(values).value);
  const std::string high = text(greatest_of(values).value);
  return low == high ? low : fmt::format("{} to {}", low, high);
}

std::vector<MeasuredFamily> plain_families(std::span<const MeasuredFamily> families) {
  std::vector<MeasuredFamily> plain;
  std::copy_if(families.begin(), families.end(), std::back_inserter(plain),
               [](const MeasuredFamily& family) {
                 return family.uniform_terrain && family.eight_neighbours;
               });
  return plain;
}

}  // namespace wend::planner_page
