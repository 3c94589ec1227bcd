#include "wend/report/planner_listing.hpp"

#include <fmt/format.h>

#include "wend/base/parse.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

std::string option_text(const OptionInfo& option) {
  const std::string alias =
      option.aliases.empty() ? "" : fmt::format(" (or {})", fmt::join(option.aliases, ", "));
  return fmt::format("    {}{} = {}: {}\n        {}\n", option.name, alias, option.default_value,
                     range_text(option), option.help);
}

std::string planner_text(const PlannerInfo& planner) {
  std::string text = fmt::format("{}\n  {}\n", planner.name, planner.summary);
  text += fmt::format("  guarantee      {}\n", planner.guarantee);
  text += fmt::format("  terrain        {}\n",
                      planner.plans_on_terrain ? "costs count" : "costs are ignored");
  text += fmt::format("  preprocessing  {}\n", to_string(planner.preprocessing));
  text += fmt::format("  paper          {}\n", planner.citation);
  if (!planner.options.empty()) text += "  options\n";
  for (const OptionInfo& option : planner.options) text += option_text(option);
  return text;
}

}  // namespace

std::string range_text(const OptionInfo& option) {
  if (option.kind == OptionKind::flag) return "true or false";
  if (option.kind != OptionKind::choice) {
    return format_number(option.least) + " to " + format_number(option.greatest);
  }
  std::string text;
  for (std::size_t i = 0; i < option.choices.size(); ++i) {
    const bool last = i + 1 == option.choices.size();
    text += (i == 0 ? "" : last ? " or " : ", ") + option.choices[i];
  }
  return text;
}

std::string planner_listing_text(const Registry<PlannerInfo>& planners) {
  std::string text;
  for (const PlannerInfo& planner : planners) {
    text += (text.empty() ? "" : "\n") + planner_text(planner);
  }
  return text;
}

std::string planner_listing_json(const Registry<PlannerInfo>& planners) {
  Json json = Json::array();
  for (const PlannerInfo& planner : planners) {
    Json options = Json::array();
    for (const OptionInfo& option : planner.options) options.push_back(json_of(option));
    json.push_back({{"name", planner.name},
                    {"summary", planner.summary},
                    {"guarantee", planner.guarantee},
                    {"promise", to_string(planner.promise)},
                    {"plans_on_terrain", planner.plans_on_terrain},
                    {"preprocessing", to_string(planner.preprocessing)},
                    {"can_step", planner.can_step},
                    {"citation", planner.citation},
                    {"options", options}});
  }
  return text_of(json);
}

}  // namespace wend
