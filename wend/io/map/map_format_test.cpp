// Properties of every format in the registry, including new ones.

#include "wend/io/map/map_format.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "conformance/random_map.hpp"
#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/losses.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

bool is_saved(const MapFormatInfo& format) { return format.save != nullptr; }

/// A map that usually has cells of every kind, and terrain that not every format holds.
GridMap mixed_map() {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int width = random.between(1, 9);
  const int height = random.between(1, 9);
  const Grid<CellState> states = test::random_states(random, width, height);
  Grid<double> terrain(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (states[{x, y}] == CellState::free) terrain[{x, y}] = random.between(1, 40) / 4.0;
      if (terrain[{x, y}] < 1) terrain[{x, y}] = 1;
    }
  }
  return *make_grid_map(states, {0.5, {}, random.chance(0.5), true}, terrain);
}

TEST(MapFormats, AreComplete) {
  for (const MapFormatInfo& format : map_formats()) {
    EXPECT_EQ(&info_of(format.format), &format) << format.name;
    EXPECT_FALSE(format.noun.empty()) << format.name;
    EXPECT_FALSE(format.extensions.empty()) << format.name;
    EXPECT_NE(format.load_lines != nullptr, format.load_bytes != nullptr) << format.name;
    EXPECT_EQ(is_saved(format), !format.saved_extensions.empty()) << format.name;
    EXPECT_EQ(format.companion.empty(), format.companion_in == nullptr) << format.name;
    EXPECT_EQ(format.largest_terrain > 1, format.nearest_terrain != nullptr) << format.name;
    EXPECT_EQ(format.terrain_values.empty(), format.nearest_terrain == nullptr) << format.name;
  }
}

TEST(MapFormats, HaveExtensionsOfTheirOwn) {
  for (const MapUse use : {MapUse::load, MapUse::save}) {
    const auto extensions = map_extensions(use);
    EXPECT_EQ(std::set(extensions.begin(), extensions.end()).size(), extensions.size());
  }
  for (const MapFormatInfo& format : map_formats()) {
    for (const std::string_view extension : format.saved_extensions) {
      EXPECT_NE(std::ranges::find(format.extensions, extension), format.extensions.end())
          << extension << " is saved and cannot be loaded";
    }
  }
}

TEST(MapFormats, AreListedInHelpAndErrorsWithAllExtensions) {
  const TemporaryFolder folder;
  const std::string unknown = error_of(load_map(folder.write("m.what", "?!")));
  for (const std::string& extension : map_extensions(MapUse::load)) {
    EXPECT_THAT(map_formats_text(MapUse::load), HasSubstr(extension));
    EXPECT_THAT(unknown, HasSubstr(extension));
  }
  for (const std::string& extension : map_extensions(MapUse::save)) {
    EXPECT_THAT(map_formats_text(MapUse::save), HasSubstr(extension));
    EXPECT_THAT(error_of(saved_format("m.what")), HasSubstr(extension));
  }
}

RC_GTEST_PROP(MapFormats, GiveBackWhatLossesDoNotName, ()) {
  const GridMap map = mixed_map();
  const TemporaryFolder folder;
  for (const std::string& extension : map_extensions(MapUse::save)) {
    const fs::path file = folder / ("m" + extension);
    const MapFormat format = *saved_format(file);
    const GridMap nearest = nearest_map(map, format);
    RC_ASSERT(save_map(nearest, file).has_value());
    const auto loaded = load_map(file);
    RC_ASSERT(loaded.has_value());
    RC_ASSERT(loaded->format == format);
    RC_ASSERT(same_map(loaded->map, nearest));
    RC_ASSERT(losses(map, format).empty() == same_map(loaded->map, map));
    RC_ASSERT(save_map(map, file).has_value() == cells_not_held(map, format).empty());
  }
}

RC_GTEST_PROP(MapFormats, AreRecognisedByTheirFirstBytes, ()) {
  const GridMap map = mixed_map();
  const TemporaryFolder folder;
  for (const std::string& extension : map_extensions(MapUse::save)) {
    const MapFormat format = *saved_format("m" + extension);
    const GridMap nearest = nearest_map(map, format);
    const fs::path file = folder / ("m" + extension);
    RC_ASSERT(save_map(nearest, file).has_value());
    fs::rename(file, folder / "no_extension");
    const auto loaded = load_map(folder / "no_extension");
    RC_ASSERT(loaded.has_value());
    RC_ASSERT(loaded->format == format);
    RC_ASSERT(same_map(loaded->map, nearest));
    const std::string bytes = bytes_of(folder / "no_extension");
    RC_ASSERT(std::ranges::count_if(map_formats(), [&](const MapFormatInfo& info) {
                return info.recognises(bytes);
              }) == 1);
  }
}

}  // namespace
}  // namespace wend
