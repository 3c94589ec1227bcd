#include "wend/io/map/image_file.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "wend/io/io_test_support.hpp"
#include "wend/io/map/load_map.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ImageFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("m.pgm", "P2 2 1 255 0 254\n");
    fs::create_directories(folder_ / "maps");
  }

  Expected<ImageFile, Error> find(const std::string& name) {
    return find_image(name, {"m.yaml", folder_.path()});
  }

  Expected<LoadedMap, Error> load(const std::string& image) {
    return load_map(folder_.write("m.yaml", "image: " + image +
                                                "\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                                                "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  }

  TemporaryFolder folder_;
};

TEST_F(ImageFiles, AreTakenWhereTheYamlSaysWithoutAWord) {
  folder_.write("maps/m.pgm", "P2 1 1 255 0\n");
  for (const std::string& name :
       {std::string("m.pgm"), std::string("./m.pgm"), (folder_ / "m.pgm").string(),
        std::string("maps/m.pgm"), std::string("maps/../m.pgm")}) {
    const auto found = find(name);
    ASSERT_TRUE(found) << error_of(found);
    EXPECT_EQ(found->file, folder_.path() / name);
    EXPECT_THAT(found->note, IsEmpty()) << name;
  }
}

TEST_F(ImageFiles, OfAnotherComputerAreTakenBesideTheYamlWithANote) {
  for (const std::string name :
       {"/home/someone/maps/m.pgm", "maps/m.pgm", "C:\\maps\\m.pgm", "..\\maps\\m.pgm",
        "~/maps of mine/m.pgm", "file:///home/x/m.pgm"}) {
    const auto found = find(name);
    ASSERT_TRUE(found) << error_of(found);
    EXPECT_EQ(found->file, folder_ / "m.pgm") << name;
    EXPECT_THAT(found->note, HasSubstr("beside the map.yaml")) << name;
  }
  const auto loaded = load("/home/someone/maps/m.pgm");
  ASSERT_TRUE(loaded) << error_of(loaded);
  EXPECT_THAT(loaded->notes, ElementsAre("the image is not at /home/someone/maps/m.pgm; " +
                                         (folder_ / "m.pgm").string() +
                                         " is read, which lies beside the map.yaml"));
  EXPECT_EQ(loaded->image_note, loaded->notes[0]);
  EXPECT_THAT(loaded->files, Contains(folder_ / "m.pgm"));
}

TEST_F(ImageFiles, MayBeNamedAsWindowsWritesPaths) {
  folder_.write("maps/n.pgm", "P2 1 1 255 0\n");
  const auto found = find("maps\\n.pgm");
  ASSERT_TRUE(found) << error_of(found);
  EXPECT_EQ(found->file, folder_ / "maps/n.pgm");
  EXPECT_THAT(found->note, HasSubstr("the same path with slashes"));
}

TEST_F(ImageFiles, TildeIsTheHomeFolder) {
  const char* const home = std::getenv("HOME");
  const std::string before = home == nullptr ? "" : home;
  folder_.write("maps/h.pgm", "P2 1 1 255 0\n");
  setenv("HOME", folder_.path().c_str(), 1);
  const auto found = find("~/maps/h.pgm");
  setenv("HOME", before.c_str(), 1);
  ASSERT_TRUE(found) << error_of(found);
  EXPECT_EQ(found->file, folder_ / "maps/h.pgm");
  EXPECT_THAT(found->note, IsEmpty());
}

TEST_F(ImageFiles, AnErrorNamesEveryPlace) {
  const auto found = find("/home/someone/gone.pgm");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message,
            "m.yaml: image /home/someone/gone.pgm: cannot be opened: No such file or directory; "
            "also looked for " +
                (folder_ / "gone.pgm").string() + ", beside the map.yaml");
  EXPECT_EQ(error_of(find("gone.pgm")), "m.yaml: image " + (folder_ / "gone.pgm").string() +
                                            ": cannot be opened: No such file or directory");
  const std::string windows = error_of(find("maps\\gone.pgm"));
  EXPECT_THAT(windows, HasSubstr((folder_ / "maps\\gone.pgm").string()));
  EXPECT_THAT(windows, HasSubstr((folder_ / "maps/gone.pgm").string()));
  EXPECT_THAT(windows, HasSubstr((folder_ / "gone.pgm").string()));
}

}  // namespace
}  // namespace wend
