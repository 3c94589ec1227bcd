#pragma once

// A map.yaml with an image beside it, in a folder of its own. Up to the first NUL, which no YAML
// has, the bytes are the map.yaml; what follows is image.pgm. Without a NUL that is a good image.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "checks.hpp"
#include "wend/io/map/map_yaml.hpp"

namespace wend::test {

/// A folder that goes when the program ends; map.yaml is to lie in it.
class FuzzedFolder {
 public:
  FuzzedFolder() {
    std::string name = std::filesystem::temp_directory_path() / "wend_fuzz_XXXXXX";
    path_ = mkdtemp(name.data());
    for (const std::string image : {"p5.pgm", "image.pgm"}) write(image, kGoodImage);
  }
  ~FuzzedFolder() {
    std::error_code error;  // ignored: a destructor cannot report it
    std::filesystem::remove_all(path_, error);
  }
  FuzzedFolder(const FuzzedFolder&) = delete;
  FuzzedFolder& operator=(const FuzzedFolder&) = delete;

  std::filesystem::path operator/(std::string_view file) const { return path_ / file; }

  void write(const std::string& file, std::string_view bytes) const {
    std::ofstream(path_ / file, std::ios::binary) << bytes;
  }

  static constexpr std::string_view kGoodImage =
      "P2 4 3 255 0 254 255 127 205 10 250 89 90 200 207 128\n";

 private:
  std::filesystem::path path_;
};

inline std::string fuzz_map_yaml(std::string_view bytes) {
  static const FuzzedFolder folder;
  const std::size_t end = bytes.find('\0');
  const bool own_image = end != std::string_view::npos;
  if (own_image) folder.write("image.pgm", bytes.substr(end + 1));
  const std::string file = folder / "map.yaml";
  const std::string text(bytes.substr(0, end));
  const auto loaded = load_map_yaml(text, {file, folder / ""});
  if (own_image) folder.write("image.pgm", FuzzedFolder::kGoodImage);
  if (!loaded) return check_error(loaded.error(), file);
  const std::string wrong = check_map(loaded->map);
  if (!wrong.empty()) return wrong;

  MapYaml yaml = *parse_map_yaml(text, file);
  const auto again = parse_map_yaml(format_map_yaml(yaml), file);
  if (!again) return "a saved map.yaml does not load: " + again.error().message;
  const bool same = again->image == yaml.image && again->frame == yaml.frame &&
                    again->meaning.mode == yaml.meaning.mode &&
                    again->meaning.negate == yaml.meaning.negate &&
                    again->meaning.occupied_threshold == yaml.meaning.occupied_threshold &&
                    again->meaning.free_threshold == yaml.meaning.free_threshold;
  return same ? "" : "another map.yaml comes back";
}

}  // namespace wend::test
