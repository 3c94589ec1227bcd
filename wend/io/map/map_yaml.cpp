#include "wend/io/map/map_yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wend/base/parse.hpp"
#include "wend/io/map/yaml_documents.hpp"
#include "wend/io/quote.hpp"
#include "wend/io/read_file.hpp"
#include "wend/io/utf8.hpp"

namespace wend {
namespace {

constexpr std::size_t kLargestYaml = std::size_t{64} << 10;

constexpr std::array<std::string_view, 7> kKeys = {
    "image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};

constexpr std::array<ImageMode, 3> kModes = {ImageMode::trinary, ImageMode::scale, ImageMode::raw};

std::string_view name_of(ImageMode mode) {
  switch (mode) {
    case ImageMode::trinary:
      return "trinary";
    case ImageMode::scale:
      return "scale";
    case ImageMode::raw:
      break;
  }
  return "raw";
}

/// Plain, quoted, and YAML's own types; any other tag asks for something that we do not do.
bool is_known_tag(const std::string& tag) {
  constexpr std::string_view kStandard = "tag:yaml.org,2002:";
  if (tag.empty() || tag == "?" || tag == "!") return true;
  if (!tag.starts_with(kStandard)) return false;
  const std::string_view type = std::string_view(tag).substr(kStandard.size());
  return type == "str" || type == "int" || type == "float" || type == "bool" || type == "seq" ||
         type == "map" || type == "null";
}

// What yaml-cpp says repeats words of the file.
constexpr std::size_t kLongestComplaint = 200;

// Errors repeat the name of the image.
constexpr std::size_t kLongestImageName = 1000;

/// Text without line ends and tabs, which would make a mess of messages.
bool is_line(const std::string& text) {
  return !first_non_text(text) && text.find_first_of("\t\r\n") == std::string::npos;
}

std::size_t line_of(const YAML::Node& node) {
  const YAML::Mark mark = node.Mark();
  return mark.is_null() ? 0 : static_cast<std::size_t>(mark.line) + 1;
}

/// A number as YAML writes it; `.inf` and `.nan` are left out, no key of ours can use them.
std::optional<double> number_of(const YAML::Node& node) {
  if (!node.IsScalar()) return std::nullopt;
  std::string_view text = node.Scalar();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return parse_number(text);
}

class MapYamlReader {
 public:
  explicit MapYamlReader(const std::string& file) : file_(file) {}

  Expected<MapYaml, IoError> read(const YAML::Node& root) {
    root_ = root;
    if (!root_.IsMap()) return failure(root_, "the top level must be a mapping, key: value");
    if (auto good = check_keys(); !good) return Unexpected<IoError>(good.error());
    MapYaml yaml;
    yaml.frame.y_up = true;
    yaml.frame.metric = true;
    for (const auto step : {&MapYamlReader::read_image, &MapYamlReader::read_resolution,
                            &MapYamlReader::read_origin, &MapYamlReader::read_negate,
                            &MapYamlReader::read_thresholds, &MapYamlReader::read_mode}) {
      if (auto good = (this->*step)(yaml); !good) return Unexpected<IoError>(good.error());
    }
    yaml.notes = std::move(notes_);
    return yaml;
  }

 private:
  using Result = Expected<void, IoError>;

  Unexpected<IoError> failure(const YAML::Node& node, std::string what) const {
    return io_failure(file_, line_of(node), std::move(what));
  }

  Result check_keys() {
    std::set<std::string> seen;
    for (const auto& entry : root_) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
      if (!seen.insert(key).second) {
        return failure(entry.first, fmt::format("duplicate key {}", quote(key)));
      }
      if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
        notes_.push_back(fmt::format("unknown key {} in the map.yaml is ignored", quote(key)));
      }
    }
    return {};
  }

  /// The value of a key that must be there.
  Expected<YAML::Node, IoError> value_of(const char* key) const {
    YAML::Node node = root_[key];
    if (!node.IsDefined()) return io_failure(file_, 0, fmt::format("'{}' is missing", key));
    if (!is_known_tag(node.Tag())) {
      return failure(node, fmt::format("'{}' has the unknown tag {}", key, quote(node.Tag())));
    }
    return node;
  }

  /// A finite number under `name`, which is how errors call it.
  Expected<double, IoError> finite_number(const YAML::Node& node, const std::string& name) const {
    const auto number = number_of(node);
    if (number && std::isfinite(*number)) return *number;
    if (node.IsNull()) return failure(node, name + " has no value");
    const std::string text = node.IsScalar() ? quote(node.Scalar()) : "a list or a mapping";
    return failure(node, fmt::format("{} is not a finite number: {}", name, text));
  }

  Expected<double, IoError> finite_number(const char* key) const {
    const auto node = value_of(key);
    if (!node) return Unexpected<IoError>(node.error());
    return finite_number(*node, key);
  }

  Result read_image(MapYaml& yaml) {
    const auto node = value_of("image");
    if (!node) return Unexpected<IoError>(node.error());
    if (!node->IsScalar()) return failure(*node, "image must be a file name");
    if (node->Scalar().empty()) return failure(*node, "image is empty");
    if (!is_line(node->Scalar())) return failure(*node, "image is not a file name");
    if (node->Scalar().size() > kLongestImageName) {
      return failure(*node, fmt::format("image is no file name: it is longer than {} bytes",
                                        kLongestImageName));
    }
    yaml.image = node->Scalar();
    return {};
  }

  Result read_resolution(MapYaml& yaml) {
    const auto resolution = finite_number("resolution");
    if (!resolution) return Unexpected<IoError>(resolution.error());
    if (*resolution <= 0) {
      return failure(root_["resolution"],
                     fmt::format("resolution must be above 0, not {}", *resolution));
    }
    yaml.frame.resolution = *resolution;
    return {};
  }

  Result read_origin(MapYaml& yaml) {
    const auto origin = value_of("origin");
    if (!origin) return Unexpected<IoError>(origin.error());
    if (!origin->IsSequence()) return failure(*origin, "origin must be a list [x, y, yaw]");
    if (origin->size() != 3) {
      return failure(*origin, fmt::format("origin must have 3 elements, not {}", origin->size()));
    }
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto number = finite_number((*origin)[i], fmt::format("origin[{}]", i));
      if (!number) return Unexpected<IoError>(number.error());
      numbers[i] = *number;
    }
    yaml.frame.origin = {numbers[0], numbers[1], numbers[2]};
    return {};
  }

  Result read_negate(MapYaml& yaml) {
    const auto node = value_of("negate");
    if (!node) return Unexpected<IoError>(node.error());
    const std::string text = node->IsScalar() ? node->Scalar() : "";
    if (text == "0" || text == "1") {
      yaml.meaning.negate = text == "1";
    } else if (!YAML::convert<bool>::decode(*node, yaml.meaning.negate)) {
      return failure(*node, fmt::format("negate must be 0, 1, false or true, not {}", quote(text)));
    }
    return {};
  }

  Result read_thresholds(MapYaml& yaml) {
    for (const auto& [key, threshold] :
         {std::pair{"occupied_thresh", &yaml.meaning.occupied_threshold},
          std::pair{"free_thresh", &yaml.meaning.free_threshold}}) {
      const auto number = finite_number(key);
      if (!number) return Unexpected<IoError>(number.error());
      if (*number < 0 || *number > 1) {
        return failure(root_[key], fmt::format("{} must be in 0..1, not {}", key, *number));
      }
      *threshold = *number;
    }
    if (yaml.meaning.free_threshold >= yaml.meaning.occupied_threshold) {
      return failure(root_["free_thresh"],
                     fmt::format("free_thresh {} must be below occupied_thresh {}",
                                 yaml.meaning.free_threshold, yaml.meaning.occupied_threshold));
    }
    return {};
  }

  Result read_mode(MapYaml& yaml) {
    if (!root_["mode"].IsDefined()) return {};
    const auto node = value_of("mode");
    if (!node) return Unexpected<IoError>(node.error());
    const std::string text = node->IsScalar() ? node->Scalar() : "";
    for (const ImageMode mode : kModes) {
      if (text != name_of(mode)) continue;
      yaml.meaning.mode = mode;
      return {};
    }
    return failure(*node, fmt::format("mode must be trinary, scale or raw, not {}", quote(text)));
  }

  const std::string& file_;
  YAML::Node root_;
  std::vector<std::string> notes_;
};

/// The number of the line that byte `at` is in.
std::size_t line_at(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace

Expected<MapYaml, IoError> parse_map_yaml(const std::string& text, const std::string& file) {
  if (text.size() > kLargestYaml) {
    return io_failure(file, 0, fmt::format("{} bytes are too many for a map.yaml", text.size()));
  }
  if (const auto at = first_non_text(text)) {
    return io_failure(file, line_at(text, *at),
                      fmt::format("not a YAML text: {} is no UTF-8 text", quote(text[*at])));
  }
  try {
    if (yaml_documents(text) > 1) {
      return io_failure(file, 0, "one document expected, there is more after it");
    }
    const YAML::Node document = YAML::Load(text);
    if (document.IsNull()) return io_failure(file, 0, "empty document");
    return MapYamlReader(file).read(document);
  } catch (const YAML::Exception& error) {
    const std::size_t line =
        error.mark.is_null() ? 0 : static_cast<std::size_t>(error.mark.line) + 1;
    return io_failure(file, line, "YAML: " + printable(error.msg, kLongestComplaint));
  }
}

std::string format_map_yaml(const MapYaml& yaml) {
  const Pose& origin = yaml.frame.origin;
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << yaml.image.string();
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {}\norigin: [{}, {}, {}]\nnegate: {}\n"
      "occupied_thresh: {}\nfree_thresh: {}\n",
      emitter.c_str(), name_of(yaml.meaning.mode), format_number(yaml.frame.resolution),
      format_number(origin.x), format_number(origin.y), format_number(origin.heading),
      yaml.meaning.negate ? 1 : 0, format_number(yaml.meaning.occupied_threshold),
      format_number(yaml.meaning.free_threshold));
}

Expected<LoadedMap, IoError> load_map_yaml(const std::string& text, const std::string& file,
                                           const std::filesystem::path& folder,
                                           double scale_factor) {
  auto yaml = parse_map_yaml(text, file);
  if (!yaml) return Unexpected<IoError>(yaml.error());
  yaml->meaning.scale_factor = scale_factor;

  const std::filesystem::path image_file = folder / yaml->image;
  const auto bytes = read_file(image_file);
  if (!bytes) return io_failure(file, 0, "image " + bytes.error().message());
  ImageMapRows rows(yaml->meaning);
  const auto notes = decode_image(*bytes, rows);
  if (!notes) {
    return io_failure(file, 0, "image " + image_file.string() + ": " + notes.error());
  }
  LoadedMap loaded{rows.finish(yaml->frame), MapFormat::ros_yaml, std::move(yaml->notes)};
  loaded.files.push_back(image_file);
  loaded.notes.insert(loaded.notes.end(), notes->begin(), notes->end());
  return loaded;
}

}  // namespace wend
