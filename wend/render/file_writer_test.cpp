#include "wend/render/file_writer.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

namespace wend {
namespace {

namespace fs = std::filesystem;

class FileWriter : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("wend_file_writer_" + std::to_string(getpid()));
};

TEST_F(FileWriter, WritesAndReplaces) {
  const fs::path file = folder_ / "picture.png";
  ASSERT_TRUE(write_picture(file, "first"));
  ASSERT_TRUE(write_picture(file, std::string_view("\0second", 7)));
  EXPECT_EQ(contents(file), std::string("\0second", 7));
  EXPECT_EQ(files(), 1);
}

TEST_F(FileWriter, NamesTheFileThatCannotBeWritten) {
  const fs::path file = folder_ / "missing" / "picture.png";
  const auto written = write_picture(file, "bytes");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message(), file.string() + ": No such file or directory");
  EXPECT_EQ(files(), 0);
}

TEST_F(FileWriter, LeavesAFolderAlone) {
  const auto written = write_picture(folder_, "bytes");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().what, "Is a directory");
  EXPECT_EQ(files(), 0);
}

TEST_F(FileWriter, LeavesWhatWasThereWhenTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const auto written = write_picture("/dev/full", "bytes");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message(), "/dev/full: No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(FileWriter, WritesThroughLinks) {
  const fs::path file = folder_ / "target.png";
  const fs::path link = folder_ / "link.png";
  fs::create_symlink(file, link);
  ASSERT_TRUE(write_picture(link, "bytes"));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(contents(file), "bytes");
}

}  // namespace
}  // namespace wend
