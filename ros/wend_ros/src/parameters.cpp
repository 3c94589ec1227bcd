#include "wend_ros/parameters.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>

#include "wend/base/parse.hpp"
#include "wend/io/primitives/load_primitives.hpp"
#include "wend/io/text.hpp"
#include "wend/path/smoothing/gradient_smoother.hpp"
#include "wend/path/trajectory.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/footprint.hpp"
#include "wend_nav2/field_parameter.hpp"

namespace wend_ros {
namespace {

using wend::OptionInfo;
using wend::OptionKind;

/// What concerns all planners, besides the fields of robots and requests.
struct NodeOptions {
  bool unknown_free = false;
  bool rough = false;
  double cost_factor = 4;
  double time_limit = 0;
  ReplanOnChange replan_on_change = ReplanOnChange::ahead;
  bool smooth = true;
  double smooth_alpha = wend::GradientOptions{}.alpha;
  double smooth_beta = wend::GradientOptions{}.beta;

  template <class Self, class Field>
  static void fields(Self& self, Field&& field) {
    field({"unknown_free", "the robot may drive on unknown cells"}, self.unknown_free);
    field({"rough", "map values below the obstacles' threshold are rough ground"}, self.rough);
    field({"cost_factor", "what the greatest value of rough ground adds to a cost of 1"},
          self.cost_factor, {0, 1e6});
    field({"time_limit", "limit on the search time, s; 0: none"}, self.time_limit, {0, 3600});
    field(
        {"replan_on_change",
         "plan again to the topics' goal after a change of the map: ahead, if it touches the path "
         "ahead or there is no path; always; never"},
        self.replan_on_change);
    field({"smooth", "publish a smoothed path as well"}, self.smooth);
    field({"smooth_alpha", "weight that holds the points of the path in place"}, self.smooth_alpha,
          {0, 2});
    field({"smooth_beta", "weight that pulls neighbouring points together"}, self.smooth_beta,
          {0, 1});
  }
};

/// Fields that messages have, or that mean something else here: `unknown_free` says what `unknown` does.
constexpr std::array<std::string_view, 7> kNoParameters{
    "unknown", "time_limit", "expansions", "explain", "from_field", "straighten", "spacing"};

/// Where a robot that drives needs another default: as the tolerance of planners of Nav2, a robot that has slipped, and a
/// map that shows a part of the world.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kDefaults{
    {{"nearest_limit", "0.5"}, {"escape", "0.25"}, {"outside", "blocked"}}};

OptionInfo option_of(const wend::FieldInfo& field) {
  constexpr double kLargest = 1e3;
  OptionInfo option = wend_nav2::parameter_of(field, kLargest);
  for (const auto& [name, value] : kDefaults) {
    if (option.name == name) option.default_value = value;
  }
  return option;
}

template <class Target>
std::vector<const wend::Field<Target>*> parameters_among(
    std::span<const wend::Field<Target>> fields) {
  std::vector<const wend::Field<Target>*> found;
  for (const wend::Field<Target>& field : fields) {
    const bool elsewhere = std::ranges::find(kNoParameters, field.info.name) != kNoParameters.end();
    if (!elsewhere) found.push_back(&field);
  }
  return found;
}

OptionInfo planner_option() {
  return {.name = "planner",
          .aliases = {},
          .kind = OptionKind::choice,
          .default_value = "astar",
          .choices = wend::planners().names(),
          .help = "name of the planner"};
}

constexpr std::string_view kFootprint = "footprint";
constexpr std::string_view kPrimitives = "primitives";

/// A parameter that is text with rules of its own; empty is always right.
struct TextParameter {
  std::string_view name;
  std::string_view help;
  std::string (*fault)(std::string_view);  // what is wrong with a text, empty if nothing is
};

std::string fault_of_footprint(std::string_view text) {
  const auto footprint = wend::parse_footprint(text);
  return footprint ? std::string() : footprint.error().message;
}

std::string fault_of_primitives(std::string_view file) {
  const auto primitives = wend::load_primitives(file);
  return primitives ? std::string() : primitives.error().message;
}

constexpr std::array kTexts{
    TextParameter{kFootprint,
                  "the robot's shape in place of robot_radius: [[x, y], ...] in m, x ahead, or "
                  "rect:LENGTHxWIDTH[,AHEAD]",
                  fault_of_footprint},
    TextParameter{kPrimitives, "file of the robot's motion primitives, for the planner lattice",
                  fault_of_primitives}};

OptionInfo option_of(const TextParameter& parameter) {
  return {.name = std::string(parameter.name),
          .aliases = {},
          .kind = OptionKind::choice,
          .default_value = "",
          .choices = {},
          .help = std::string(parameter.help)};
}

/// Of options of the same name, one that takes what any of them does.
void merge(std::vector<OptionInfo>& schema, const OptionInfo& option) {
  const auto same = std::ranges::find(schema, option.name, &OptionInfo::name);
  if (same == schema.end()) {
    schema.push_back(option);
    return;
  }
  for (const std::string& choice : option.choices) {
    if (std::ranges::find(same->choices, choice) == same->choices.end()) {
      same->choices.push_back(choice);
    }
  }
  same->least = std::min(same->least, option.least);
  same->greatest = std::max(same->greatest, option.greatest);
}

std::vector<OptionInfo> full_schema() {
  std::vector<OptionInfo> schema{planner_option()};
  for (const TextParameter& parameter : kTexts) schema.push_back(option_of(parameter));
  for (const auto* field : robot_parameters()) schema.push_back(option_of(field->info));
  for (const OptionInfo& option : wend::option_schema<NodeOptions>()) schema.push_back(option);
  for (const auto* field : request_parameters()) schema.push_back(option_of(field->info));
  for (const OptionInfo& option : wend::option_schema<wend::TrajectoryLimits>()) {
    schema.push_back(option);
  }
  for (const wend::PlannerInfo& planner : wend::planners()) {
    for (const OptionInfo& option : planner.options) merge(schema, option);
  }
  return schema;
}

bool is_called(const OptionInfo& option, std::string_view name) {
  if (name.empty()) return false;
  return option.name == name || option.former == name ||
         std::ranges::find(option.aliases, name) != option.aliases.end();
}

/// What is wrong with a value, empty if nothing is.
std::string fault_of(const OptionInfo& option, std::string_view text) {
  const auto* const typed = std::ranges::find(kTexts, option.name, &TextParameter::name);
  if (typed != kTexts.end()) return text.empty() ? std::string() : typed->fault(text);
  return wend::option_text::fault_of(option, text);
}

bool is_true(std::string_view text) {
  bool value = false;
  wend::option_text::parse(text, value);
  return value;
}

std::string type_of(OptionKind kind) {
  switch (kind) {
    case OptionKind::flag:
      return "bool";
    case OptionKind::integer:
      return "int";
    case OptionKind::number:
      return "double";
    case OptionKind::choice:
      return "str";
  }
  return "str";
}

/// The choices as dynamic_reconfigure's clients read them: a Python literal.
std::string edit_method(const OptionInfo& option) {
  if (option.choices.empty()) return {};
  std::string text = "{'enum_description': '" + option.help + "', 'enum': [";
  for (std::size_t i = 0; i < option.choices.size(); ++i) {
    const std::string& choice = option.choices[i];
    text += std::string(i > 0 ? ", " : "") + "{'name': '" + choice +
            "', 'type': 'str', 'value': '" + choice + "', 'description': '" + choice +
            "', 'srcline': 0, 'srcfile': '', 'cconsttype': 'const char * const', 'ctype': "
            "'std::string'}";
  }
  return text + "]}";
}

template <class Message, class Value>
Message entry(const std::string& name, Value value) {
  Message message;
  message.name = name;
  message.value = value;
  return message;
}

}  // namespace

std::vector<const wend::RequestField*> request_parameters() {
  return parameters_among(wend::request_fields());
}

std::vector<const wend::RobotField*> robot_parameters() {
  return parameters_among(wend::robot_fields());
}

Parameters::Parameters() : schema_(full_schema()) {
  for (const OptionInfo& option : schema_) values_.push_back(option.default_value);
}

const OptionInfo* Parameters::find(std::string_view name) const {
  const auto found = std::ranges::find_if(
      schema_, [&](const OptionInfo& option) { return is_called(option, name); });
  return found == schema_.end() ? nullptr : &*found;
}

std::string Parameters::set(std::string_view name, std::string_view value) {
  const OptionInfo* option = find(name);
  if (option == nullptr) return "there is no parameter " + wend::quote(name);
  const std::string fault = fault_of(*option, value);
  if (!fault.empty()) return "parameter " + wend::quote(name) + ": " + fault;
  values_[static_cast<std::size_t>(option - schema_.data())] = value;
  if (option->name == kPrimitives) read_primitives();
  return {};
}

const std::string& Parameters::text(std::string_view name) const {
  const OptionInfo* option = find(name);
  assert(option != nullptr);
  return values_[static_cast<std::size_t>(option - schema_.data())];
}

double Parameters::number(std::string_view name) const {
  return wend::parse_number(text(name)).value_or(0);
}

bool Parameters::flag(std::string_view name) const { return is_true(text(name)); }

ReplanOnChange Parameters::replan_on_change() const {
  const std::string& chosen = text("replan_on_change");
  for (const auto& choice : choice_names(ReplanOnChange{})) {
    if (choice.name == chosen) return choice.value;
  }
  return {};
}

wend::Footprint Parameters::footprint() const {
  const std::string& shape = text(kFootprint);
  if (shape.empty()) return wend::Footprint::disc(number("robot_radius"));
  return wend::parse_footprint(shape).value_or(wend::Footprint());
}

/// Once: a robot with other primitives is another robot, for which all is made anew.
void Parameters::read_primitives() {
  primitives_.reset();
  auto loaded = wend::load_primitives(text(kPrimitives));
  if (loaded) primitives_ = *std::move(loaded);
}

wend::OptionValues Parameters::options_of(std::string_view planner) const {
  wend::OptionValues values;
  const wend::PlannerInfo* info = wend::planners().find(planner);
  if (info == nullptr) return values;
  for (const OptionInfo& option : info->options) {
    const std::string& value = text(option.name);
    // The planner chooses the values of unset options.
    if (value == find(option.name)->default_value || !fault_of(option, value).empty()) continue;
    values.emplace_back(option.name, value);
  }
  return values;
}

dynamic_reconfigure::ConfigDescription Parameters::description() const {
  dynamic_reconfigure::ConfigDescription description;
  dynamic_reconfigure::Group group;
  group.name = "Default";
  for (const OptionInfo& option : schema_) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = option.name;
    parameter.type = type_of(option.kind);
    parameter.description = option.help;
    parameter.edit_method = edit_method(option);
    group.parameters.push_back(parameter);
  }
  description.groups = {group};
  std::vector<std::string> least;
  std::vector<std::string> greatest;
  std::vector<std::string> defaults;
  for (const OptionInfo& option : schema_) {
    const bool number = option.kind == OptionKind::integer || option.kind == OptionKind::number;
    least.push_back(number ? wend::format_number(option.least) : option.default_value);
    greatest.push_back(number ? wend::format_number(option.greatest) : option.default_value);
    defaults.push_back(option.default_value);
  }
  description.min = config_of(least);
  description.max = config_of(greatest);
  description.dflt = config_of(defaults);
  return description;
}

dynamic_reconfigure::Config Parameters::config() const { return config_of(values_); }

dynamic_reconfigure::Config Parameters::config_of(const std::vector<std::string>& values) const {
  dynamic_reconfigure::Config config;
  for (std::size_t i = 0; i < schema_.size(); ++i) {
    const OptionInfo& option = schema_[i];
    const double number = wend::parse_number(values[i]).value_or(0);
    switch (option.kind) {
      case OptionKind::flag:
        config.bools.push_back(
            entry<dynamic_reconfigure::BoolParameter>(option.name, is_true(values[i])));
        break;
      case OptionKind::integer:
        config.ints.push_back(entry<dynamic_reconfigure::IntParameter>(
            option.name,
            static_cast<std::int32_t>(std::clamp<double>(number, INT32_MIN, INT32_MAX))));
        break;
      case OptionKind::number:
        config.doubles.push_back(entry<dynamic_reconfigure::DoubleParameter>(option.name, number));
        break;
      case OptionKind::choice:
        config.strs.push_back(entry<dynamic_reconfigure::StrParameter>(option.name, values[i]));
        break;
    }
  }
  dynamic_reconfigure::GroupState group;
  group.name = "Default";
  group.state = true;
  config.groups = {group};
  return config;
}

std::vector<std::string> Parameters::apply(const dynamic_reconfigure::Config& config) {
  std::vector<std::string> faults;
  const auto take = [&](const std::string& name, const std::string& value) {
    std::string fault = set(name, value);
    if (!fault.empty()) faults.push_back(std::move(fault));
  };
  for (const auto& given : config.bools) take(given.name, given.value ? "true" : "false");
  for (const auto& given : config.ints) take(given.name, std::to_string(given.value));
  for (const auto& given : config.doubles) take(given.name, wend::format_number(given.value));
  for (const auto& given : config.strs) take(given.name, given.value);
  return faults;
}

}  // namespace wend_ros
