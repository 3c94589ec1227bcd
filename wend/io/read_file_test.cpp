#include "wend/io/read_file.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::EndsWith;

TEST(ReadFile, GivesTheBytes) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xFF", 6);
  EXPECT_EQ(read_file(folder.write("file", bytes)), bytes);
  EXPECT_EQ(read_file(folder.write("empty", "")), "");
}

TEST(ReadFile, SaysWhyAFileCannotBeOpened) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(read_file(folder / "missing")),
            (folder / "missing").string() + ": cannot be opened: No such file or directory");
}

TEST(ReadFile, ReadsRegularFilesOnly) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(error_of(read_file(folder / "pipe")), EndsWith("not a regular file"));
  EXPECT_THAT(error_of(read_file(folder.path())), EndsWith("not a regular file"));
  EXPECT_THAT(error_of(read_file("/dev/zero")), EndsWith("not a regular file"));
}

TEST(ReadFile, GivesALargeFileInPieces) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 600'000; ++i) bytes += std::to_string(i);
  auto pieces = FilePieces::open(folder.write("file", bytes));
  ASSERT_TRUE(pieces) << error_of(pieces);
  EXPECT_EQ(pieces->size(), bytes.size());
  std::string read;
  std::size_t count = 0;
  for (std::string_view piece = pieces->next(); !piece.empty(); piece = pieces->next(), ++count) {
    read += piece;
  }
  EXPECT_EQ(read, bytes);
  EXPECT_GT(count, 2U);
  EXPECT_FALSE(pieces->failed());
  EXPECT_TRUE(FilePieces::open(folder.write("empty", ""))->next().empty());
  EXPECT_THAT(error_of(FilePieces::open(folder.path())), EndsWith("not a regular file"));
}

TEST(ReadFile, RefusesFilesThatAreTooLarge) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_file(folder.write("four", "1234"), 4), "1234");
  EXPECT_THAT(error_of(read_file(folder.write("five", "12345"), 4)),
              EndsWith("5 bytes are too many, at most 4 are read"));
}

}  // namespace
}  // namespace wend
