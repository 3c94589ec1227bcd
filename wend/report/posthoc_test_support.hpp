#pragma once

// Helpers of the trace tests: reading traces, their rules, and an observer that records a search.

#include <yaml-cpp/yaml.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/planner/observer.hpp"
#include "wend/report/posthoc_trace.hpp"

namespace wend::test {

using nlohmann::json;

inline constexpr std::uint64_t kNoLimit = 1'000'000'000;

/// YAML as the JSON of the same data.
inline json json_of(const YAML::Node& node) {
  json value;
  if (node.IsMap()) {
    for (const auto& entry : node) value[entry.first.Scalar()] = json_of(entry.second);
  } else if (node.IsSequence()) {
    value = json::array();
    for (const auto& entry : node) value.push_back(json_of(entry));
  } else if (node.IsScalar()) {
    const bool quoted = node.Tag() == "!";
    const auto number = quoted ? std::nullopt : parse_number(node.Scalar());
    value = number ? json(*number) : json(node.Scalar());
  }
  return value;
}

inline json parsed(const std::string& text, TraceForm form) {
  return form == TraceForm::json ? json::parse(text) : json_of(YAML::Load(text));
}

inline void require(bool holds, const std::string& rule, const json& of) {
  if (!holds) throw std::runtime_error(rule + ": " + of.dump());
}

inline void check_head(const json& trace) {
  require(trace.at("version") == "1.4.0", "version", trace.at("version"));
  require(trace.at("schema") == 1, "schema", trace.at("schema"));
  const std::set<std::string> primitives{"rect", "circle", "polygon", "path"};
  require(!trace.at("views").at("main").empty(), "main shows something", trace.at("views"));
  for (const auto& [name, drawables] : trace.at("views").items()) {
    for (const json& drawable : drawables) {
      const auto kind = drawable.at("$").get<std::string>();
      require(primitives.count(kind) > 0 || trace.at("views").contains(kind), "drawable", drawable);
      std::vector<const char*> properties{"x", "y", "fill"};
      if (kind == "rect") properties.insert(properties.end(), {"width", "height"});
      if (kind == "circle") properties.push_back("radius");
      for (const char* property : properties) {
        require(drawable.contains(property), property, drawable);
      }
    }
  }
  require(trace.at("pivot").at("x").is_string() && trace.at("pivot").at("y").is_string(), "pivot",
          trace.at("pivot"));
}

/// Throws if a trace breaks a rule of the format or of the order of its events.
inline void check_trace(const json& trace) {
  check_head(trace);
  const std::set<std::string> types{"map",       "source",   "destination", "generating",
                                    "expanding", "updating", "closing",     "end"};
  std::map<std::string, std::set<json>> seen;  // ids by type of event
  std::set<json> ids;
  for (const json& event : trace.at("events")) {
    const json& id = event.at("id");
    const auto type = event.at("type").get<std::string>();
    require(id.is_number() || id.is_string(), "id", event);
    require(types.count(type) > 0, "type", event);
    if (event.contains("pId") && !event.at("pId").is_null()) {
      require(ids.count(event.at("pId")) > 0, "parent is known", event);
      require(event.at("pId") != id, "parent is another", event);
    }
    if (type == "expanding" || type == "updating") {
      require(seen["generating"].count(id) > 0, "generated before", event);
    }
    if (type == "updating") require(seen["closing"].count(id) == 0, "still open", event);
    if (type == "closing") require(seen["expanding"].count(id) > 0, "expanded before", event);
    require(seen["end"].empty(), "end comes last", event);
    const bool is_new = seen[type].insert(id).second;
    require(is_new || type == "updating" || type == "destination", "only once", event);
    ids.insert(id);
  }
}

inline std::vector<json> events_of(const json& trace, const std::set<std::string>& types) {
  std::vector<json> events;
  for (const json& event : trace.at("events")) {
    if (types.count(event.at("type").get<std::string>()) > 0) events.push_back(event);
  }
  return events;
}

/// The text from "events:" on.
inline std::string tail(const std::string& text) { return text.substr(text.find("\nevents:") + 1); }

struct Seen {
  std::string type;
  SearchEvent event;
};

/// Records a search as a trace should describe it.
class Witness final : public SearchObserver {
 public:
  void on_generate(const SearchEvent& event) override { seen_.push_back({"generating", event}); }
  void on_relax(const SearchEvent& event) override { seen_.push_back({"updating", event}); }
  void on_expand(const SearchEvent& event) override {
    close_last();
    seen_.push_back({"expanding", event});
    last_ = event;
  }
  void close_last() {
    if (last_) seen_.push_back({"closing", *last_});
  }
  const std::vector<Seen>& seen() const { return seen_; }

 private:
  std::vector<Seen> seen_;
  std::optional<SearchEvent> last_;
};

}  // namespace wend::test
