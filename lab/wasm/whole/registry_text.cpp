#include "lab/wasm/whole/registry_text.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "lab/wasm/json.hpp"
#include "wend/base/registry.hpp"
#include "wend/control/controller_fields.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/smoothing/smoother_fields.hpp"
#include "wend/planner/planner_fields.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/request_fields.hpp"
#include "wend/version.hpp"

namespace wend::lab {
namespace {

/// "guarantee_text" as scripts write it: "guaranteeText".
std::string script_name(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins_word = i > 0 && name[i - 1] == '_';
    if (name[i] != '_') text += begins_word ? static_cast<char>(name[i] - 'a' + 'A') : name[i];
  }
  return text;
}

void write(Json& json, const OptionInfo& option, std::string_view unit = {});

void write(Json& json, const std::vector<OptionInfo>& options) {
  json.array();
  for (const OptionInfo& option : options) write(json, option);
  json.end_array();
}

void write(Json& json, const std::vector<std::string>& texts) {
  json.array();
  for (const std::string& text : texts) json.value(text);
  json.end_array();
}

template <class Value>
void write(Json& json, const Value& value) {
  json.value(value);
}

/// The facts of a planner, a smoother, a controller or an option.
template <class Info>
void write_facts(Json& json, const Info& info) {
  visit_fields(info, [&json](std::string_view name, const auto& value) {
    write(json.key(script_name(name)), value);
  });
}

void write(Json& json, const OptionInfo& option, std::string_view unit) {
  write_facts(json.object(), option);
  json.field("unit", unit).end_object();
}

/// A list of fields: options with a unit.
template <class Target>
void write(Json& json, std::string_view name, std::span<const Field<Target>> fields) {
  json.key(name).array();
  for (const Field<Target>& field : fields) write(json, field.info.option(), field.info.unit);
  json.end_array();
}

void write(Json& json, const GeneratorInfo& generator) {
  json.object()
      .field("name", generator.name)
      .field("summary", generator.summary)
      .field("leastWidth", generator.least_width)
      .field("leastHeight", generator.least_height)
      .field("defaultWidth", generator.default_width)
      .field("defaultHeight", generator.default_height)
      .field("freeCorner", generator.free_corner);
  write(json.key("options"), generator.options);
  json.end_object();
}

/// A list of planners, smoothers or controllers.
template <class Info>
void write(Json& json, std::string_view name, const Registry<Info>& registry) {
  json.key(name).array();
  for (const Info& info : registry) {
    write_facts(json.object(), info);
    json.end_object();
  }
  json.end_array();
}

}  // namespace

std::string registry_text() {
  Json json;
  json.object().field("version", std::string_view(WEND_VERSION));
  write(json, "planners", planners());
  json.key("generators").array();
  for (const GeneratorInfo& generator : generators()) write(json, generator);
  json.end_array();
  write(json, "smoothers", smoothers());
  write(json, "controllers", controllers());
  write(json, "robotFields", robot_fields());
  write(json, "requestFields", request_fields());
  json.end_object();
  return json.text();
}

}  // namespace wend::lab
