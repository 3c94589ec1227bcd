// `wend convert` from outside: between all formats, on small maps and on real ones.

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "conformance/random_map.hpp"
#include "tests/command_line/run_program.hpp"
#include "wend/io/map/load_map.hpp"
#include "wend/io/map/losses.hpp"
#include "wend/io/map/save_map.hpp"

namespace wend::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> kWritten{".map", ".txt", ".grid", ".png",
                                        ".pgm", ".pnm", ".yaml", ".yml"};

/// The map as it is drawn; the error where it does not load.
std::string drawing_in(const fs::path& file) {
  const auto loaded = load_map(file);
  return loaded ? drawing_of(loaded->map) : loaded.error().message;
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Lets the picture beside a map.yaml be replaced.
std::vector<std::string> forced(const std::string& out) {
  if (out.ends_with(".yaml") || out.ends_with(".yml")) return {"--force"};
  return {};
}

class Convert : public testing::Test {
 protected:
  /// Runs `wend convert` on files of the folder. Every picture may be replaced.
  Outcome convert(const std::string& in, const std::string& out) const {
    return convert(in, out, forced(out));
  }

  Outcome convert(const std::string& in, const std::string& out,
                  const std::vector<std::string>& flags) const {
    std::vector<std::string> arguments{"convert", folder_ / in, folder_ / out};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return wend(arguments);
  }

  /// Converts, and checks what comes out against the library's word for it.
  void expect_nearest(const std::string& in, const std::string& out) const {
    const Outcome outcome = convert(in, out);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto before = load_map(folder_ / in);
    const auto after = load_map(folder_ / out);
    ASSERT_TRUE(before && after);
    const GridMap nearest = nearest_map(before->map, after->format);
    EXPECT_EQ(drawing_of(after->map), drawing_of(nearest));
    EXPECT_EQ(after->map.frame(), nearest.frame());
    EXPECT_EQ(after->map.terrain(), nearest.terrain());
    std::string told;
    for (const std::string& note : before->notes)
      told += "wend: " + (folder_ / in).string() + ": " + note + "\n";
    for (const std::string& loss : losses(before->map, after->format)) {
      told += "wend: " + (folder_ / out).string() + ": " + loss + "\n";
    }
    EXPECT_EQ(outcome.err, told);
  }

  TemporaryFolder folder_;
};

TEST_F(Convert, GoesBetweenAllFormats) {
  const std::string grid = "..#.\n#...\n..##\n";
  folder_.write("first.txt", grid);
  folder_.write("given.ppm", "P3 2 2 1\n1 1 1 0 0 0\n0 0 0 1 1 1\n");
  folder_.write("given.pbm", "P1 2 2\n0 1\n1 0\n");
  for (const std::string& from : kWritten) {
    ASSERT_EQ(convert("first.txt", "from" + from).code, 0);
    for (const std::string& to : kWritten) {
      SCOPED_TRACE(from + " to " + to);
      expect_nearest("from" + from, "to" + to);
      EXPECT_EQ(drawing_in(folder_ / ("to" + to)), grid);
    }
  }
  for (const std::string& to : kWritten) {
    expect_nearest("given.ppm", "to" + to);
    expect_nearest("given.pbm", "to" + to);
    EXPECT_EQ(drawing_in(folder_ / ("to" + to)), ".#\n#.\n");
  }
}

TEST_F(Convert, TellsEveryLossInALineOfItsOwn) {
  folder_.write("odd.txt", "?9\n.2\n");
  for (const std::string& to : kWritten) {
    SCOPED_TRACE(to);
    expect_nearest("odd.txt", "to" + to);
  }
  const std::string out = (folder_ / "odd.map").string();
  EXPECT_THAT(
      lines_in(convert("odd.txt", "odd.map").err),
      ElementsAre(
          "wend: " + out +
              ": unknown cells become occupied (1 cell): a MovingAI map cannot hold unknown cells",
          "wend: " + out +
              ": terrain is lost (2 cells): a MovingAI map cannot hold terrain, all cells cost the "
              "same"));
  EXPECT_EQ(drawing_in(out), "#.\n..\n");
}

TEST_F(Convert, StrictSavesNothingThatIsNotTheWholeMap) {
  folder_.write("odd.txt", "?.\n");
  folder_.write("odd.map", "old");
  const Outcome refused = convert("odd.txt", "odd.map", {"--strict"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.out, IsEmpty());
  EXPECT_THAT(refused.err, AllOf(HasSubstr("unknown cells"), HasSubstr("--strict")));
  EXPECT_EQ(bytes_of(folder_ / "odd.map"), "old");
  const Outcome saved = convert("odd.txt", "odd.png", {"--strict"});
  EXPECT_EQ(saved.code, 0) << saved.err;
  EXPECT_EQ(drawing_in(folder_ / "odd.png"), "?.\n");
}

TEST_F(Convert, GivesAnImageItsResolution) {
  folder_.write("map.pgm", "P2 2 1 255\n255 0\n");
  EXPECT_EQ(convert("map.pgm", "map.yaml", {"--resolution", "0.25"}).code, 0);
  const auto loaded = load_map(folder_ / "map.yaml");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->map.frame(), (Frame{0.25, {}, true, true}));
  folder_.write("map.txt", "..\n");
  const Outcome refused = convert("map.txt", "map.yaml", {"--resolution", "0.25"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--resolution is for bare images"));
}

TEST_F(Convert, HasTheSameForPrograms) {
  folder_.write("odd.txt", "?.\n");
  const json saved = json::parse(convert("odd.txt", "odd.yaml", {"--format", "json"}).out);
  EXPECT_EQ(saved.at("from"), "text grid");
  EXPECT_EQ(saved.at("to"), "ROS map.yaml");
  EXPECT_EQ(saved.at("width"), 2);
  EXPECT_EQ(saved.at("losses").size(), 2U);
  EXPECT_EQ(saved.at("files"), json({folder_ / "odd.png", folder_ / "odd.yaml"}));
  const Outcome refused = convert("odd.txt", "odd.map", {"--format", "json", "--strict"});
  EXPECT_EQ(json::parse(refused.out).at("files"), json::array());
}

TEST_F(Convert, ListsEveryMapFormatInItsHelp) {
  const std::string help = wend({"convert", "--help"}).out;
  for (const MapUse use : {MapUse::load, MapUse::save}) {
    for (const std::string& extension : map_extensions(use)) {
      EXPECT_THAT(help, HasSubstr(extension));
    }
  }
}

TEST_F(Convert, RefusesBadInput) {
  folder_.write("map.txt", "..\n");
  folder_.write("bad.map", "type octile\nheight 2\n");
  EXPECT_THAT(convert("map.txt", "map.jpg").err,
              HasSubstr("unknown map extension '.jpg'; expected .yaml,"));
  EXPECT_THAT(convert("no.map", "map.txt").err, HasSubstr("no.map: cannot be opened"));
  EXPECT_THAT(convert("bad.map", "out.txt").err, HasSubstr("bad.map:2: "));
  EXPECT_THAT(convert("map.txt", "no/such/folder.map").err, HasSubstr("cannot be written"));
  EXPECT_THAT(wend({"convert", "map.txt"}).err, HasSubstr("OUT is required"));
  for (const std::string out : {"map.jpg", "no/such/folder.map", "map"}) {
    EXPECT_EQ(convert("map.txt", out).code, 2) << out;
  }
  EXPECT_EQ(convert("bad.map", "out.txt").code, 2);
  EXPECT_FALSE(fs::exists(folder_ / "out.txt"));
}

/// Every file of the folder and its bytes.
std::map<fs::path, std::string> files_in(const fs::path& folder) {
  std::map<fs::path, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path()] = bytes_of(entry.path());
  }
  return files;
}

TEST_F(Convert, NeverWritesOverAFileThatTheMapWasReadFrom) {
  folder_.write("a.txt", "..#\n");
  ASSERT_EQ(convert("a.txt", "ros.yaml").code, 0);  // and ros.png
  ASSERT_EQ(convert("a.txt", "bare.png").code, 0);
  fs::create_symlink("a.txt", folder_ / "link.grid");
  fs::create_hard_link(folder_ / "ros.png", folder_ / "twin.png");
  const auto before = files_in(folder_ / "");
  for (const auto& [in, out] : {std::pair{"a.txt", "a.txt"},
                                {"a.txt", "./a.txt"},
                                {"a.txt", "link.grid"},
                                {"link.grid", "a.txt"},
                                {"ros.yaml", "ros.yaml"},
                                {"ros.yaml", "ros.png"},
                                {"ros.yaml", "ros.yml"},
                                {"ros.yaml", "twin.yaml"},
                                {"bare.png", "bare.yaml"}}) {
    SCOPED_TRACE(std::string(in) + " to " + out);
    const Outcome refused = convert(in, out);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("this file is also an input"));
    EXPECT_EQ(files_in(folder_ / ""), before);
  }
}

TEST_F(Convert, KeepsAPictureThatBelongsToSomethingElse) {
  folder_.write("a.txt", "..#\n");
  folder_.write("b.txt", "###\n");
  folder_.write("keep.png", "a photograph");
  const auto before = files_in(folder_ / "");
  const Outcome refused = convert("a.txt", "keep.yaml", {});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("this would replace " + (folder_ / "keep.png").string()),
                                 HasSubstr("--force")));
  EXPECT_EQ(files_in(folder_ / ""), before);
  const Outcome forced = convert("a.txt", "keep.yaml", {"--force"});
  EXPECT_EQ(forced.code, 0) << forced.err;
  EXPECT_THAT(forced.out, AllOf(HasSubstr(folder_ / "keep.png"), HasSubstr(folder_ / "keep.yaml")));
  // A command can be run again, and changed: the picture is its own now.
  EXPECT_EQ(convert("b.txt", "keep.yaml", {}).code, 0);
  EXPECT_EQ(drawing_in(folder_ / "keep.yaml"), "###\n");
  EXPECT_EQ(convert("a.txt", "keep.yml", {}).code, 2) << "it is keep.yaml's";
}

/// The smallest map of each folder of the shared data, by extension.
std::vector<fs::path> real_maps() {
  std::map<std::string, fs::path> smallest;
  for (const auto& entry : fs::recursive_directory_iterator(data_folder())) {
    const fs::path& file = entry.path();
    const std::string extension = file.extension();
    if (extension != ".map" && extension != ".yaml" && extension != ".png" && extension != ".pgm") {
      continue;
    }
    if (file.string().find("/bad/") != std::string::npos) continue;
    const std::string kind = file.parent_path().string() + extension;
    const auto found = smallest.find(kind);
    if (found != smallest.end() && fs::file_size(found->second) <= fs::file_size(file)) continue;
    if (load_map(file)) smallest[kind] = file;
  }
  std::vector<fs::path> files;
  for (const auto& [folder, file] : smallest) files.push_back(file);
  return files;
}

TEST_F(Convert, TakesRealMaps) {
  if (data_folder().empty()) GTEST_SKIP() << "WEND_DATA is not set";
  const std::vector<fs::path> files = real_maps();
  EXPECT_GT(files.size(), 20U);
  for (const fs::path& file : files) {
    for (const std::string to : {"m.map", "m.txt", "m.png", "m.yaml"}) {
      SCOPED_TRACE(file.string() + " to " + to);
      std::vector<std::string> arguments{"convert", file, folder_ / to};
      for (const std::string& flag : forced(to)) arguments.push_back(flag);
      const Outcome outcome = wend(arguments);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      const auto before = load_map(file);
      const auto after = load_map(folder_ / to);
      ASSERT_TRUE(before && after);
      EXPECT_EQ(drawing_of(after->map), drawing_of(nearest_map(before->map, after->format)));
      EXPECT_EQ(lines_in(outcome.err).size(),
                before->notes.size() + losses(before->map, after->format).size());
    }
  }
}

}  // namespace
}  // namespace wend::test
