#include "wend/report/planner_listing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "wend/base/parse.hpp"
#include "wend/io/text.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/json.hpp"

namespace wend {
namespace {

constexpr std::size_t kTitleWidth = 15;
constexpr std::size_t kLineWidth = 80;

/// The head and the text; a long text is wrapped and indented.
std::string paragraph(const std::string& head, std::string_view text) {
  std::string lines = head;
  std::size_t column = head.size();
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    const bool fits = column + word.size() <= kLineWidth;
    if (column > head.size()) lines += fits ? " " : "\n" + std::string(head.size(), ' ');
    column = (fits ? column : head.size()) + word.size() + 1;
    lines += word;
  }
  return lines + '\n';
}

/// "  title   text"
std::string entry(std::string_view title, std::string_view text) {
  return paragraph(fmt::format("  {:<{}}", title, kTitleWidth), text);
}

std::string option_text(const OptionInfo& option) {
  const std::string alias =
      option.aliases.empty() ? "" : fmt::format(" (or {})", fmt::join(option.aliases, ", "));
  return paragraph("    ", fmt::format("{}{} = {}: {}", option.name, alias, option.default_value,
                                       range_text(option))) +
         paragraph("        ", option.help);
}

std::string planner_text(const PlannerInfo& planner) {
  std::string text = planner.name + "\n" + paragraph("  ", planner.summary);
  text += entry("idea", planner.idea);
  text += entry("guarantee", planner.guarantee_text);
  text += entry("time", planner.time);
  text += entry("memory", planner.memory);
  text += entry("when", planner.when);
  text += entry("moves", planner.mover);
  text += entry("terrain", std::string(terrain_in_words(planner)));
  text += entry("preprocessing", choice_name(planner.preprocessing));
  text += entry("paper", planner.citation);
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
  return either_of(option.choices);
}

std::string planner_table(const Registry<PlannerInfo>& planners) {
  constexpr std::string_view kLine = "{:<16} {:<12} {:<6}{}\n";
  std::string text = fmt::format(kLine, "planner", "guarantee", "for", "what it does");
  for (const PlannerInfo& planner : planners) {
    text += fmt::format(kLine, planner.name, choice_name(planner.guarantee), planner.motion,
                        planner.summary);
  }
  return text + "`wend planners NAME` tells all about a planner.\n";
}

std::string planner_listing_text(const Registry<PlannerInfo>& planners) {
  std::string text;
  for (const PlannerInfo& planner : planners) {
    if (!text.empty()) text += '\n';
    text += planner_text(planner);
  }
  return text;
}

std::string planner_listing_json(const Registry<PlannerInfo>& planners) {
  Json json;
  Json& listing = json["planners"] = Json::array();
  for (const PlannerInfo& planner : planners) {
    Json options = Json::array();
    for (const OptionInfo& option : planner.options) options.push_back(json_of(option));
    listing.push_back({{"name", planner.name},
                       {"summary", planner.summary},
                       {"idea", planner.idea},
                       {"guarantee", planner.guarantee_text},
                       {"promise", choice_name(planner.guarantee)},
                       {"time", planner.time},
                       {"memory", planner.memory},
                       {"when", planner.when},
                       {"motion", planner.motion},
                       {"plans_on_terrain", planner.capabilities.terrain},
                       {"preprocessing", choice_name(planner.preprocessing)},
                       {"can_step", planner.capabilities.can_step},
                       {"citation", planner.citation},
                       {"options", options}});
  }
  return text_of(json);
}

}  // namespace wend
