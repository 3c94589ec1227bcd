#include "docs/planner_page/registry_part.hpp"

#include <fmt/format.h>

#include "docs/planner_page/markdown.hpp"
#include "wend/planner/planners.hpp"
#include "wend/report/planner_listing.hpp"

namespace wend::planner_page {
namespace {

std::string overview() {
  MarkdownTable table({{"planner"}, {"guarantee"}, {"terrain"}, {"time"}, {"memory"}});
  for (const PlannerInfo& planner : planners()) {
    table.add({link_to(planner.name), planner.guarantee_text,
               std::string(terrain_in_words(planner)), planner.time, planner.memory});
  }
  return table.text();
}

std::string options_of(const PlannerInfo& planner) {
  MarkdownTable table({{"option"}, {"default"}, {"values"}, {"meaning"}});
  for (const OptionInfo& option : planner.options) {
    std::string names = code(option.name);
    for (const std::string& alias : option.aliases) names += fmt::format(" or {}", code(alias));
    table.add({names, option.default_value, range_text(option), option.help});
  }
  return table.text();
}

std::string section(const PlannerInfo& planner, const Picture& picture) {
  std::string text =
      fmt::format("### {}\n\n{}.\n\n{}\n\n", planner.name, planner.summary, planner.idea);
  text += fmt::format("![What {0} expands]({1}/{0}.png)\n\n*{2}*\n\n", planner.name, kImages,
                      picture.caption);
  const auto item = [&text](std::string_view title, std::string_view what) {
    text += fmt::format("- **{}**: {}\n", title, what);
  };
  item("Guarantee", planner.guarantee_text);
  item("Time", planner.time);
  item("Memory", planner.memory);
  item("Terrain", std::string(terrain_in_words(planner)));
  item("Preprocessing", choice_name(planner.preprocessing));
  item("When", planner.when);
  item("Paper", planner.citation);
  if (!planner.options.empty()) text += fmt::format("\n{}", options_of(planner));
  return text;
}

}  // namespace

std::string registry_part(std::span<const Picture> pictures) {
  std::string text = "## All at once\n\n" + overview();
  text +=
      "\nn is the number of cells that a search expands, at most all that can be reached. Memory "
      "is reserved for the whole map and touched only where a search goes; beginning a search "
      "takes no time, whatever the size of the map.\n";
  text += "\n## One by one\n\n" + about_pictures() + "\n";
  std::size_t number = 0;
  for (const PlannerInfo& planner : planners())
    text += fmt::format("\n{}", section(planner, pictures[number++]));
  return text;
}

}  // namespace wend::planner_page
