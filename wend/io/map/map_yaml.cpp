#include "wend/io/map/map_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "wend/base/parse.hpp"
#include "wend/io/files.hpp"
#include "wend/io/image/grey_image.hpp"
#include "wend/io/map/doubts.hpp"
#include "wend/io/map/image_file.hpp"

namespace wend {
namespace {

constexpr std::size_t kLargestYaml = std::size_t{64} << 10;
constexpr std::size_t kLongestComplaint = 200;   // yaml-cpp's messages repeat words of the file
constexpr std::size_t kLongestImageName = 1000;  // errors repeat it

constexpr std::array<std::string_view, 7> kKeys = {
    "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};

constexpr std::array<std::string_view, 3> kModes = {"trinary", "scale", "raw"};  // as in ImageMode

class IgnoredEvents : public YAML::EventHandler {
 public:
  using Mark = YAML::Mark;
  using Anchor = YAML::anchor_t;
  using Style = YAML::EmitterStyle::value;

  void OnDocumentStart(const Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const Mark&, Anchor) override {}
  void OnAlias(const Mark&, Anchor) override {}
  void OnScalar(const Mark&, const std::string&, Anchor, const std::string&) override {}
  void OnSequenceStart(const Mark&, const std::string&, Anchor, Style) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const Mark&, const std::string&, Anchor, Style) override {}
  void OnMapEnd() override {}
};

/// Whether a text has more than one document. Throws YAML::Exception if it is not YAML.
/// YAML::LoadAll() cannot be used: after a stray ',' at the top level it makes documents for ever.
bool has_more_documents(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  IgnoredEvents events;
  return parser.HandleNextDocument(events) && parser.HandleNextDocument(events);
}

/// Is it the tag of a plain or quoted value, or of YAML's own types? Other tags are not supported.
bool is_known_tag(std::string_view tag) {
  constexpr std::string_view kStandard = "tag:yaml.org,2002:";
  constexpr std::array<std::string_view, 7> kTypes = {"str", "int", "float", "bool",
                                                      "seq", "map", "null"};
  if (tag.empty() || tag == "?" || tag == "!") return true;
  if (!tag.starts_with(kStandard)) return false;
  return std::ranges::find(kTypes, tag.substr(kStandard.size())) != kTypes.end();
}

/// Is the text free of line ends and tabs, which would garble messages?
bool is_line(const std::string& text) {
  return !first_non_text(text) && text.find_first_of("\t\r\n") == std::string::npos;
}

std::size_t line_of(const YAML::Mark& mark) {
  return mark.is_null() ? 0 : static_cast<std::size_t>(mark.line) + 1;
}

/// A number in YAML syntax, without `.inf` and `.nan`, which no key of map.yaml can use.
std::optional<double> number_of(const YAML::Node& node) {
  if (!node.IsScalar()) return std::nullopt;
  std::string_view text = node.Scalar();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return parse_number(text);
}

std::string text_of(const YAML::Node& node) { return node.IsScalar() ? node.Scalar() : ""; }

/// Reads the keys one after the other, and keeps the first error.
class MapYamlReader {
 public:
  MapYamlReader(const YAML::Node& root, const std::string& file) : root_(root), file_(file) {}

  Expected<MapYaml, Error> read() {
    yaml_.frame.y_up = true;
    yaml_.frame.metric = true;
    for (const auto step :
         {&MapYamlReader::check_keys, &MapYamlReader::read_image, &MapYamlReader::read_resolution,
          &MapYamlReader::read_origin, &MapYamlReader::read_negate, &MapYamlReader::read_thresholds,
          &MapYamlReader::read_mode}) {
      (this->*step)();
      if (error_) return Unexpected<Error>(*error_);
    }
    return std::move(yaml_);
  }

 private:
  void fail(const YAML::Node& node, const std::string& what) {
    if (!error_) error_ = file_error(file_, line_of(node.Mark()), what);
  }

  void check_keys() {
    if (!root_.IsMap()) return fail(root_, "the top level must be a mapping, key: value");
    std::set<std::string> seen;
    for (const auto& entry : root_) {
      const std::string key = text_of(entry.first);
      if (!seen.insert(key).second) fail(entry.first, fmt::format("duplicate key {}", quote(key)));
      if (std::ranges::find(kKeys, key) == kKeys.end()) {
        yaml_.notes.push_back(fmt::format("unknown key {} in the map.yaml is ignored", quote(key)));
      }
    }
  }

  /// The value of a required key; null if it is wrong.
  YAML::Node value_of(const char* key) {
    const YAML::Node node = root_[key];
    if (node.IsDefined() && is_known_tag(node.Tag())) return node;
    if (node.IsDefined()) {
      fail(node, fmt::format("'{}' has the unknown tag {}", key, quote(node.Tag())));
    } else if (!error_) {
      error_ = file_error(file_, 0, fmt::format("the key '{}' is missing", key));
    }
    return {};
  }

  /// A finite number; errors call it `name`.
  double finite_number(const YAML::Node& node, const std::string& name) {
    const auto number = number_of(node);
    if (number && std::isfinite(*number)) return *number;
    if (node.IsNull()) {
      fail(node, name + " has no value");
    } else {
      fail(node, fmt::format("{} must be a finite number, not {}", name,
                             node.IsScalar() ? quote(node.Scalar()) : "a list or a mapping"));
    }
    return 0;
  }

  void read_image() {
    const YAML::Node node = value_of("image");
    const std::string name = text_of(node);
    if (!node.IsScalar() || !is_line(name)) return fail(node, "image must be a file name");
    if (name.empty()) return fail(node, "image is empty");
    if (name.size() > kLongestImageName) {
      return fail(node,
                  fmt::format("image: the file name is longer than {} bytes", kLongestImageName));
    }
    yaml_.image = name;
  }

  void read_resolution() {
    const YAML::Node node = value_of("resolution");
    yaml_.frame.resolution = finite_number(node, "resolution");
    if (yaml_.frame.resolution > 0) return;
    fail(node, fmt::format("resolution must be above 0, not {}", yaml_.frame.resolution));
  }

  void read_origin() {
    const YAML::Node origin = value_of("origin");
    if (!origin.IsSequence()) return fail(origin, "origin must be a list [x, y, yaw]");
    if (origin.size() != 3) {
      return fail(origin, fmt::format("origin must have 3 elements, not {}", origin.size()));
    }
    yaml_.frame.origin = {finite_number(origin[0], "origin[0]"),
                          finite_number(origin[1], "origin[1]"),
                          finite_number(origin[2], "origin[2]")};
  }

  void read_negate() {
    const YAML::Node node = value_of("negate");
    const std::string text = text_of(node);
    if (text == "0" || text == "1") {
      yaml_.meaning.negate = text == "1";
    } else if (!YAML::convert<bool>::decode(node, yaml_.meaning.negate)) {
      fail(node, fmt::format("negate must be 0, 1, false or true, not {}", quote(text)));
    }
  }

  double threshold(const char* key) {
    const YAML::Node node = value_of(key);
    const double number = finite_number(node, key);
    if (!(number >= 0 && number <= 1)) {
      fail(node, fmt::format("{} must be in 0..1, not {}", key, number));
    }
    return number;
  }

  void read_thresholds() {
    ImageMeaning& meaning = yaml_.meaning;
    meaning.occupied_threshold = threshold("occupied_thresh");
    meaning.free_threshold = threshold("free_thresh");
    if (meaning.free_threshold < meaning.occupied_threshold) return;
    fail(root_["free_thresh"], fmt::format("free_thresh {} must be below occupied_thresh {}",
                                           meaning.free_threshold, meaning.occupied_threshold));
  }

  void read_mode() {
    if (!root_["mode"].IsDefined()) return;
    const YAML::Node node = value_of("mode");
    const std::string text = text_of(node);
    const auto mode = std::ranges::find(kModes, text);
    if (mode == kModes.end()) {
      return fail(node, fmt::format("mode must be trinary, scale or raw, not {}", quote(text)));
    }
    yaml_.meaning.mode = static_cast<ImageMode>(mode - kModes.begin());
  }

  const YAML::Node root_;
  const std::string& file_;
  MapYaml yaml_;
  std::optional<Error> error_;
};

bool is_map_yaml(std::string_view bytes) {
  if (looks_like_image(bytes)) return false;
  return bytes.starts_with("image:") || bytes.find("\nimage:") != std::string_view::npos;
}

Expected<MapFiles, Error> save_map_yaml(const GridMap& map, const std::filesystem::path& file) {
  if (!map.frame().y_up && map.frame().origin != MapPose{}) {
    return failure(Status::unsupported_map,
                   "a ROS map.yaml cannot hold an origin of a map with y down", "origin");
  }
  const bool uniform = map.uniform_terrain();
  auto image = encode_png(uniform ? trinary_image(map) : scale_image(map));
  if (!image) return Unexpected<Error>(image.error());
  const MapYaml yaml{.image = file.filename().replace_extension(".png"),
                     .frame = map.frame(),
                     .meaning = uniform ? ImageMeaning{} : kScaleMeaning};
  return MapFiles{format_map_yaml(yaml), *std::move(image)};
}

std::optional<std::filesystem::path> image_in(const std::string& text) {
  auto yaml = parse_map_yaml(text, {});
  return yaml ? std::optional(std::move(yaml->image)) : std::nullopt;
}

}  // namespace

Expected<MapYaml, Error> parse_map_yaml(const std::string& text, const std::string& file) {
  if (text.size() > kLargestYaml) {
    return file_failure(file, 0,
                        fmt::format("too large for a map.yaml: {} bytes, the limit is {}",
                                    text.size(), kLargestYaml));
  }
  if (const auto at = first_non_text(text)) {
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(*at), '\n');
    return file_failure(file, static_cast<std::size_t>(lines) + 1,
                        fmt::format("not YAML: byte {} is not UTF-8 text", quote(text[*at])));
  }
  try {
    if (has_more_documents(text)) {
      return file_failure(file, 0, "expected one YAML document, there is another after it");
    }
    const YAML::Node document = YAML::Load(text);
    if (document.IsNull()) return file_failure(file, 0, "the file is empty; expected a map.yaml");
    return MapYamlReader(document, file).read();
  } catch (const YAML::Exception& error) {
    return file_failure(file, line_of(error.mark),
                        "YAML: " + printable(error.msg, kLongestComplaint));
  }
}

std::string format_map_yaml(const MapYaml& yaml) {
  const MapPose& origin = yaml.frame.origin;
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << yaml.image.string();
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {}\norigin: [{}, {}, {}]\nnegate: {}\n"
      "occupied_thresh: {}\nfree_thresh: {}\n",
      emitter.c_str(), kModes[static_cast<std::size_t>(yaml.meaning.mode)],
      format_number(yaml.frame.resolution), format_number(origin.x), format_number(origin.y),
      format_number(origin.heading), yaml.meaning.negate ? 1 : 0,
      format_number(yaml.meaning.occupied_threshold), format_number(yaml.meaning.free_threshold));
}

Expected<LoadedMap, Error> load_map_yaml(const std::string& text, const MapSource& source,
                                         const LoadOptions& options) {
  auto yaml = parse_map_yaml(text, source.file);
  if (!yaml) return Unexpected<Error>(yaml.error());
  yaml->meaning.scale_factor = options.scale_factor;

  const auto image = find_image(yaml->image.string(), source);
  if (!image) return Unexpected<Error>(image.error());
  const std::filesystem::path& image_file = image->file;
  const auto bytes = read_file(image_file);
  if (!bytes) return file_failure(source.file, 0, "image " + bytes.error().message);
  ImageMapRows rows(yaml->meaning);
  const auto notes = decode_image(*bytes, rows);
  if (!notes) {
    return file_failure(source.file, 0,
                        "image " + image_file.string() + ": " + notes.error().message);
  }
  auto map = rows.finish(yaml->frame);
  if (!map) return file_failure(source.file, 0, map.error().message);
  LoadedMap loaded{*std::move(map), MapFormat::map_yaml, std::move(yaml->notes), {image_file}};
  loaded.image_note = image->note;
  if (!image->note.empty()) loaded.notes.push_back(image->note);
  for (const auto& more :
       {*notes, doubts_about(yaml->frame), doubts_about(rows, yaml->meaning, loaded.map)}) {
    loaded.notes.insert(loaded.notes.end(), more.begin(), more.end());
  }
  return loaded;
}

MapFormatInfo map_yaml_format() {
  return {.format = MapFormat::map_yaml,
          .name = "ROS map.yaml",
          .noun = "a ROS map.yaml",
          .extensions = {".yaml", ".yml"},
          .saved_extensions = {".yaml", ".yml"},
          .companion = ".png",
          .holds_frame = true,
          .largest_terrain = nearest_scaled_terrain(kScaleMeaning.scale_factor + 1),
          .terrain_values = "1 + 4 v/100 for whole v",
          .nearest_terrain = nearest_scaled_terrain,
          .recognises = is_map_yaml,
          .load_bytes = load_map_yaml,
          .save = save_map_yaml,
          .companion_in = image_in};
}

}  // namespace wend
