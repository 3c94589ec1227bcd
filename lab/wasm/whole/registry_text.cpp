#include "lab/wasm/whole/registry_text.hpp"

#include "lab/wasm/json.hpp"
#include "wend/control/controller.hpp"
#include "wend/generate/generators.hpp"
#include "wend/path/smoothing/smoother.hpp"
#include "wend/planner/planners.hpp"
#include "wend/robot/robot_fields.hpp"
#include "wend/session/request_fields.hpp"
#include "wend/version.hpp"

namespace wend::lab {
namespace {

void write(Json& json, const OptionInfo& option, std::string_view unit = {}) {
  json.object()
      .field("name", option.name)
      .field("kind", to_string(option.kind))
      .field("default", option.default_value)
      .field("help", option.help)
      .field("unit", unit)
      .field("least", option.least)
      .field("greatest", option.greatest);
  json.key("choices").array();
  for (const std::string& choice : option.choices) json.value(choice);
  json.end_array().end_object();
}

/// A list of fields: options with a unit.
template <class Target>
void write(Json& json, std::string_view name, std::span<const Field<Target>> fields) {
  json.key(name).array();
  for (const Field<Target>& field : fields) write(json, field.info.option(), field.info.unit);
  json.end_array();
}

void write(Json& json, const std::vector<OptionInfo>& options) {
  json.key("options").array();
  for (const OptionInfo& option : options) write(json, option);
  json.end_array();
}

void write(Json& json, const PlannerInfo& planner) {
  json.object()
      .field("name", planner.name)
      .field("summary", planner.summary)
      .field("idea", planner.idea)
      .field("citation", planner.citation)
      .field("guarantee", choice_name(planner.guarantee))
      .field("guaranteeText", planner.guarantee_text)
      .field("when", planner.when)
      .field("terrain", terrain_in_words(planner))
      .field("headings", planner.capabilities.headings)
      .field("canStep", planner.capabilities.can_step)
      .field("resumes", planner.capabilities.resumes)
      .field("onVertices", planner.capabilities.vertices != Vertices::centres)
      .field("needsIndex", planner.index_support != nullptr);
  write(json, planner.options);
  json.end_object();
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
  write(json, generator.options);
  json.end_object();
}

void write(Json& json, const SmootherInfo& smoother) {
  json.object()
      .field("name", smoother.name)
      .field("summary", smoother.summary)
      .field("citation", smoother.citation)
      .field("drives", smoother.drives);
  write(json, smoother.options);
  json.end_object();
}

void write(Json& json, const ControllerInfo& controller) {
  json.object()
      .field("name", controller.name)
      .field("summary", controller.summary)
      .field("citation", controller.citation)
      .field("turnsInPlace", controller.turns_in_place);
  write(json, controller.options);
  json.end_object();
}

}  // namespace

std::string registry_text() {
  Json json;
  json.object().field("version", std::string_view(WEND_VERSION));
  json.key("planners").array();
  for (const PlannerInfo& planner : planners()) write(json, planner);
  json.end_array().key("generators").array();
  for (const GeneratorInfo& generator : generators()) write(json, generator);
  json.end_array().key("smoothers").array();
  for (const SmootherInfo& smoother : smoothers()) write(json, smoother);
  json.end_array().key("controllers").array();
  for (const ControllerInfo& controller : controllers()) write(json, controller);
  json.end_array();
  write(json, "robotFields", robot_fields());
  write(json, "requestFields", request_fields());
  json.end_object();
  return json.text();
}

}  // namespace wend::lab
