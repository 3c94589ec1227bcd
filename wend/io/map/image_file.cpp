#include "wend/io/map/image_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

#include "wend/io/text.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHome = "~/";
constexpr std::size_t kLongestPlace = 250;  // bytes, in a message that names several

/// A place that cannot be looked at, such as the home folder of somebody else, is one where the image is not.
bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error) && !error;
}

fs::path at_home(const std::string& name) {
  const char* const home = std::getenv("HOME");
  if (!name.starts_with(kHome) || home == nullptr || *home == '\0') return name;
  return fs::path(home) / name.substr(kHome.size());
}

std::string with_slashes(std::string name) {
  std::ranges::replace(name, '\\', '/');
  return name;
}

/// The places in the order in which they are tried, each once.
std::vector<fs::path> places_of(const std::string& name, const fs::path& folder) {
  const std::string plain = with_slashes(name);
  std::vector<fs::path> places;
  for (const fs::path& named : {at_home(name), at_home(plain), fs::path(plain).filename()}) {
    const fs::path place = folder / named;
    const bool known = std::ranges::any_of(places, [&](const fs::path& other) {
      return other.lexically_normal() == place.lexically_normal();
    });
    if (!named.empty() && !known) places.push_back(place);
  }
  return places;
}

}  // namespace

Expected<ImageFile, Error> find_image(const std::string& name, const MapSource& source) {
  const std::vector<fs::path> places = places_of(name, source.folder);
  const auto found = std::ranges::find_if(places, is_there);
  if (found == places.begin()) return ImageFile{*found, {}};
  if (found != places.end()) {
    const bool beside = found->parent_path() == source.folder;
    return ImageFile{
        *found,
        fmt::format("the image is not at {}; {} is read, {}", places[0].string(), found->string(),
                    beside ? "which lies beside the map.yaml" : "the same path with slashes")};
  }
  std::string message =
      fmt::format("image {}: cannot be opened: No such file or directory", places[0].string());
  for (std::size_t i = 1; i < places.size(); ++i) {
    message += fmt::format("{} {}", i == 1 ? "; also looked for" : " and",
                           text_line(places[i].string(), kLongestPlace));
  }
  if (places.size() > 1) message += ", beside the map.yaml";
  return file_failure(source.file, 0, message);
}

}  // namespace wend
