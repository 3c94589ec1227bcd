#include "wend/io/map/map_yaml.hpp"

#include <gmock/gmock.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string kRest = "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
const std::string kGood = "image: m.pgm\nresolution: 0.05\norigin: [-1.0, -2.0, 0.5]\n" + kRest;

MapYaml yaml_in(const std::string& text) {
  auto yaml = parse_map_yaml(text, "y");
  EXPECT_TRUE(yaml) << error_of(yaml);
  return yaml.value_or(MapYaml{});
}

std::string error_in(const std::string& text) { return error_of(parse_map_yaml(text, "y")); }

/// kGood with the line of `key` replaced by `line`, or removed if `line` is empty.
std::string with(const std::string& key, const std::string& line) {
  const std::size_t begin = kGood.find(key + ":");
  const std::size_t end = kGood.find('\n', begin) + 1;
  return kGood.substr(0, begin) + (line.empty() ? "" : line + "\n") + kGood.substr(end);
}

TEST(MapYaml, SaysHowToReadAnImage) {
  const MapYaml yaml = yaml_in(kGood);
  EXPECT_EQ(yaml.image, "m.pgm");
  EXPECT_EQ(yaml.frame.resolution, 0.05);
  EXPECT_EQ(yaml.frame.origin, (MapPose{-1, -2, 0.5}));
  EXPECT_TRUE(yaml.frame.y_up);
  EXPECT_TRUE(yaml.frame.metric);
  EXPECT_EQ(yaml.meaning.mode, ImageMode::trinary);
  EXPECT_FALSE(yaml.meaning.negate);
  EXPECT_EQ(yaml.meaning.occupied_threshold, 0.65);
  EXPECT_EQ(yaml.meaning.free_threshold, 0.196);
  EXPECT_THAT(yaml.notes, IsEmpty());
}

TEST(MapYaml, IsYaml) {
  EXPECT_EQ(yaml_in("--- # a map\n" + kGood + "...\n").image, "m.pgm");
  EXPECT_EQ(yaml_in(with("image", "image: \"a b.pgm\"  # quoted")).image, "a b.pgm");
  EXPECT_EQ(yaml_in(with("image", "image: m.pgm\r")).image, "m.pgm");
  EXPECT_EQ(yaml_in(with("resolution", "resolution: '5e-2'")).frame.resolution, 0.05);
  EXPECT_EQ(yaml_in(with("resolution", "resolution: +0.05")).frame.resolution, 0.05);
  EXPECT_EQ(yaml_in(with("origin", "origin:\n  - 1\n  - 2\n  - 3")).frame.origin,
            (MapPose{1, 2, 3}));
  EXPECT_EQ(yaml_in(with("origin", "origin: [&z 0.5, *z, *z]")).frame.origin,
            (MapPose{0.5, 0.5, 0.5}));
}

TEST(MapYaml, EveryKeyButModeIsRequired) {
  for (const std::string key :
       {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
    EXPECT_EQ(error_in(with(key, "")), "y: the key '" + key + "' is missing");
  }
}

TEST(MapYaml, KeysAreUnique) {
  EXPECT_EQ(error_in(kGood + "resolution: 0.5\n"), "y:7: duplicate key 'resolution'");
  EXPECT_EQ(error_in(kGood + "x: 0\nx: 1\n"), "y:8: duplicate key 'x'");
}

TEST(MapYaml, UnknownKeysAreNoted) {
  EXPECT_THAT(yaml_in(kGood + "floor: 2\n").notes,
              ElementsAre("unknown key 'floor' in the map.yaml is ignored"));
}

TEST(MapYaml, ImageIsAFileName) {
  EXPECT_EQ(error_in(with("image", "image: \"\"")), "y:1: image is empty");
  EXPECT_EQ(error_in(with("image", "image: [a, b]")), "y:1: image must be a file name");
  EXPECT_EQ(error_in(with("image", "image: \"m.pgm\\0.txt\"")), "y:1: image must be a file name");
  EXPECT_EQ(error_in(with("image", "image: \"m\\n.pgm\"")), "y:1: image must be a file name");
  EXPECT_EQ(error_in(with("image", "image: \"m\\e[2J.pgm\"")), "y:1: image must be a file name");
  EXPECT_THAT(error_in("image: \"m\\"), testing::HasSubstr("unknown escape character: \\x"));
  EXPECT_EQ(error_in(with("image", "image: " + std::string(1001, 'm'))),
            "y:1: image: the file name is longer than 1000 bytes");
}

TEST(MapYaml, UnknownTagsAreErrors) {
  EXPECT_EQ(error_in(with("image", "image: !!python/object/apply:os.system [\"x\"]")),
            "y:1: 'image' has the unknown tag 'tag:yaml.org,2002:python/object/apply:os'...");
  EXPECT_EQ(yaml_in(with("image", "image: !!str 007")).image, "007");
}

TEST(MapYaml, ResolutionIsFiniteAndAboveZero) {
  EXPECT_EQ(error_in(with("resolution", "resolution: 0")),
            "y:2: resolution must be above 0, not 0");
  EXPECT_EQ(error_in(with("resolution", "resolution: -0.05")),
            "y:2: resolution must be above 0, not -0.05");
  EXPECT_EQ(error_in(with("resolution", "resolution: [1]")),
            "y:2: resolution must be a finite number, not a list or a mapping");
  EXPECT_THAT(error_in(with("resolution", "resolution:")), EndsWith("resolution has no value"));
  for (const std::string text : {"nan", ".nan", ".inf", "1e999", "0.05 m", "0x10", "high", "+-1"}) {
    EXPECT_EQ(error_in(with("resolution", "resolution: " + text)),
              "y:2: resolution must be a finite number, not '" + text + "'");
  }
}

TEST(MapYaml, OriginHasThreeFiniteNumbers) {
  EXPECT_EQ(error_in(with("origin", "origin: [1, 2]")), "y:3: origin must have 3 elements, not 2");
  EXPECT_EQ(error_in(with("origin", "origin: [1, 2, 3, 4]")),
            "y:3: origin must have 3 elements, not 4");
  EXPECT_EQ(error_in(with("origin", "origin: {x: 1, y: 2, yaw: 3}")),
            "y:3: origin must be a list [x, y, yaw]");
  EXPECT_EQ(error_in(with("origin", "origin: [1, .nan, 3]")),
            "y:3: origin[1] must be a finite number, not '.nan'");
}

TEST(MapYaml, NegateIsABoolean) {
  for (const std::string text : {"1", "true", "True", "yes"}) {
    EXPECT_TRUE(yaml_in(with("negate", "negate: " + text)).meaning.negate);
  }
  for (const std::string text : {"0", "false", "no"}) {
    EXPECT_FALSE(yaml_in(with("negate", "negate: " + text)).meaning.negate);
  }
  EXPECT_EQ(error_in(with("negate", "negate: 2")),
            "y:4: negate must be 0, 1, false or true, not '2'");
  EXPECT_EQ(error_in(with("negate", "negate: []")),
            "y:4: negate must be 0, 1, false or true, not ''");
}

TEST(MapYaml, ThresholdsAreInOrderBetweenZeroAndOne) {
  EXPECT_EQ(error_in(with("occupied_thresh", "occupied_thresh: 65")),
            "y:5: occupied_thresh must be in 0..1, not 65");
  EXPECT_EQ(error_in(with("free_thresh", "free_thresh: -0.1")),
            "y:6: free_thresh must be in 0..1, not -0.1");
  EXPECT_EQ(error_in(with("free_thresh", "free_thresh: 0.65")),
            "y:6: free_thresh 0.65 must be below occupied_thresh 0.65");
}

TEST(MapYaml, ModeIsOneOfThreeAndCaseMatters) {
  EXPECT_EQ(yaml_in(kGood + "mode: trinary\n").meaning.mode, ImageMode::trinary);
  EXPECT_EQ(yaml_in(kGood + "mode: \"scale\"\n").meaning.mode, ImageMode::scale);
  EXPECT_EQ(yaml_in(kGood + "mode: raw\n").meaning.mode, ImageMode::raw);
  EXPECT_EQ(error_in(kGood + "mode: Trinary\n"),
            "y:7: mode must be trinary, scale or raw, not 'Trinary'");
}

TEST(MapYaml, IsOneMapping) {
  EXPECT_EQ(error_in(""), "y: the file is empty; expected a map.yaml");
  EXPECT_EQ(error_in("# nothing\n"), "y: the file is empty; expected a map.yaml");
  EXPECT_EQ(error_in("map.pgm\n"), "y:1: the top level must be a mapping, key: value");
  EXPECT_EQ(error_in("[1, 2]\n"), "y:1: the top level must be a mapping, key: value");
  EXPECT_EQ(error_in(kGood + "---\n" + kGood),
            "y: expected one YAML document, there is another after it");
  // For some of these YAML::LoadAll() makes documents for ever.
  for (const std::string stray : {",", "]", "}", ", x", "? ,\n", "a: b\n,", "- ]\n"}) {
    EXPECT_THAT(error_in(stray), StartsWith("y:")) << stray;
  }
}

TEST(MapYaml, SyntaxErrorsHaveALine) {
  EXPECT_THAT(error_in(with("origin", "origin: [1, 2")), StartsWith("y:4: YAML: "));
  EXPECT_THAT(error_in("image: m.pgm\nresolution:0.05\norigin: [0, 0, 0]\n"),
              StartsWith("y:3: YAML: "));
}

TEST(MapYaml, IsUtf8Text) {
  EXPECT_EQ(yaml_in(with("image", "image: caf\xC3\xA9.pgm")).image, "caf\xC3\xA9.pgm");
  EXPECT_EQ(error_in(with("image", "image: caf\xE9.pgm")),
            "y:1: not YAML: byte 0xE9 is not UTF-8 text");
  EXPECT_EQ(error_in(kGood + std::string(1, '\0')), "y:7: not YAML: byte 0x00 is not UTF-8 text");
}

TEST(MapYaml, AliasesAreNotExpanded) {
  std::string bomb = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
  for (char name = 'b'; name < 'z'; ++name) {
    const std::string before = "*" + std::string(1, static_cast<char>(name - 1)) + " ";
    bomb += std::string(1, name) + ": &" + name + " [";
    for (int i = 0; i < 10; ++i) bomb += before + (i < 9 ? ", " : "]\n");
  }
  EXPECT_THAT(error_in(bomb + with("origin", "origin: *y")),
              HasSubstr("origin must have 3 elements, not 10"));
  EXPECT_THAT(error_in(bomb + with("origin", "origin: [*y , *y , *y ]")),
              HasSubstr("origin[0] must be a finite number, not a list or a mapping"));
}

TEST(MapYaml, DeepNestingIsAnError) {
  EXPECT_NE(error_in(kGood + "x: " + std::string(60000, '[')), "no error");
}

TEST(MapYaml, IsSmall) {
  EXPECT_EQ(error_in(kGood + std::string(65536, '#')),
            "y: too large for a map.yaml: " + std::to_string(kGood.size() + 65536) +
                " bytes, the limit is 65536");
}

TEST(MapYaml, WrittenYamlReadsBack) {
  MapYaml yaml;
  yaml.image = "a \"b\"\\: \xC3\xA9#.png";
  yaml.frame = {0.1, {-1.0 / 3, 2e-7, -3.1}, true, true};
  yaml.meaning = {ImageMode::scale, true, 1, 0, 4};
  const MapYaml read = yaml_in(format_map_yaml(yaml));
  EXPECT_EQ(read.image, yaml.image);
  EXPECT_EQ(read.frame, yaml.frame);
  EXPECT_EQ(read.meaning.mode, yaml.meaning.mode);
  EXPECT_EQ(read.meaning.negate, yaml.meaning.negate);
  EXPECT_EQ(read.meaning.occupied_threshold, 1);
  EXPECT_EQ(read.meaning.free_threshold, 0);
}

TEST(LoadMapYaml, ReadsTheImageBesideTheYaml) {
  const TemporaryFolder folder;
  folder.write("m.pgm", "P2 2 2 255 0 255 128 255");
  const auto loaded = load_map_yaml(kGood, {folder / "m.yaml", folder.path()});
  ASSERT_TRUE(loaded) << error_of(loaded);
  EXPECT_EQ(cells_of(loaded->map), "?.\n#.\n");
  EXPECT_EQ(loaded->map.frame().origin, (MapPose{-1, -2, 0.5}));
  EXPECT_EQ(loaded->format, MapFormat::map_yaml);
}

TEST(LoadMapYaml, TheImageMayLieAnywhere) {
  const TemporaryFolder images;
  const auto image = images.write("m.pgm", "P2 1 1 255 0");
  const TemporaryFolder folder;
  EXPECT_TRUE(
      load_map_yaml(with("image", "image: " + image.string()), {folder / "m.yaml", folder.path()}));
}

TEST(LoadMapYaml, ErrorsAboutTheImageNameBothFiles) {
  const TemporaryFolder folder;
  const std::string both =
      (folder / "m.yaml").string() + ": image " + (folder / "m.pgm").string() + ": ";
  const auto error = [&] {
    return error_of(load_map_yaml(kGood, {folder / "m.yaml", folder.path()}));
  };
  EXPECT_EQ(error(), both + "cannot be opened: No such file or directory");
  folder.write("m.pgm", "P2 2 2 255 0");
  EXPECT_EQ(error(), both + "pixel data truncated: 2 bytes, expected at least 7");
}

TEST(LoadMapYaml, PassesOnWhatIsOddAboutTheImage) {
  const TemporaryFolder folder;
  folder.write("m.pgm", "P2 1 1 255 0 10");
  EXPECT_THAT(load_map_yaml(kGood + "floor: 2\n", {folder / "m.yaml", folder.path()})->notes,
              ElementsAre("unknown key 'floor' in the map.yaml is ignored",
                          "2 bytes after the last pixel of the image are ignored"));
}

}  // namespace
}  // namespace wend
