// wend reference: every subcommand and option as JSON. scripts/reference.py makes the man pages and the
// site's pages from it. It is hidden because it is for scripts.

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments/flags.hpp"
#include "cli/arguments/help_formatter.hpp"
#include "cli/commands/developer_commands.hpp"
#include "cli/developers/developers.hpp"
#include "cli/exit_code.hpp"
#include "cli/output/output.hpp"
#include "wend/version.hpp"

namespace wend::cli {
namespace {

using Json = nlohmann::ordered_json;

/// "wend index build"
std::string full_name(const CLI::App& app) {
  const CLI::App* parent = app.get_parent();
  return (parent == nullptr ? "" : full_name(*parent) + " ") + app.get_name();
}

std::string usage_of(const CLI::App& app) {
  const std::string usage = HelpFormatter().make_usage(&app, full_name(app));  // "Usage: ...\n"
  const std::size_t begin = usage.find(": ") + 2;
  return usage.substr(begin, usage.find_last_not_of('\n') + 1 - begin);
}

bool is_positional(const CLI::Option& option) { return !option.nonpositional(); }

Json argument_json(const CLI::Option& option) {
  const std::string value = option.get_type_name();
  Json json;
  if (is_positional(option)) {
    json["name"] = option.get_name(true, false);
  } else {
    json["names"] = shown_names(option);
  }
  json["value"] = value.empty() ? Json() : Json(value);
  json["value_optional"] = !value.empty() && option.get_items_expected_max() == 0;
  json["repeatable"] = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  json["required"] = option.get_required();
  if (!is_positional(option)) json["group"] = option.get_group();
  json["help"] = unwrapped(option.get_description());
  return json;
}

/// What stands below the options: indented lines are examples, the rest are paragraphs.
struct Footer {
  std::vector<std::string> examples;
  std::vector<std::string> notes;
};

Footer split_footer(std::string_view text) {
  Footer footer;
  bool goes_on = false;  // the paragraph
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    const bool is_note = !line.empty() && !line.starts_with("  ") && line != "Examples:";
    if (line.starts_with("  ")) footer.examples.push_back(line.substr(2));
    if (is_note && goes_on) footer.notes.back() += " " + line;
    if (is_note && !goes_on) footer.notes.push_back(line);
    goes_on = is_note;
  }
  return footer;
}

Json command_json(const CLI::App& app) {
  const Footer footer = split_footer(app.get_footer());
  Json json{{"name", full_name(app)},   {"summary", app.get_description()},
            {"usage", usage_of(app)},   {"positionals", Json::array()},
            {"options", Json::array()}, {"examples", footer.examples},
            {"notes", footer.notes},    {"subcommands", Json::array()}};
  for (const CLI::Option* option : app.get_options()) {
    const bool shown = is_positional(*option) && !option->get_group().empty();
    if (shown) json["positionals"].push_back(argument_json(*option));
  }
  for (const std::string& group : app.get_groups()) {
    for (const CLI::Option* option : options_in(app, group)) {
      json["options"].push_back(argument_json(*option));
    }
  }
  for (const CLI::App* each : visible_subcommands(app)) {
    json["subcommands"].push_back(command_json(*each));
  }
  return json;
}

int run(const CLI::App& app) {
  Json json{{"schema", 1}, {"version", WEND_VERSION}};
  json.update(command_json(app));
  print(json.dump() + '\n');
  return success;
}

}  // namespace

Command add_reference(Parser& app) {
  Parser reference = app.add_subcommand("reference", kReferenceDescription);
  reference.hide();
  return {reference, [app] { return run(app.app()); }};
}

}  // namespace wend::cli
