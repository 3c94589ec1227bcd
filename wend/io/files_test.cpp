#include "wend/io/files.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;
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
              EndsWith("too large: 5 bytes, the limit is 4"));
}

/// The reading end of a pipe into which a thread writes.
class Pipe {
 public:
  explicit Pipe(std::string bytes) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe(ends.data()), 0);
    reader_ = ends[0];
    thread_ = std::thread([writer = ends[1], bytes = std::move(bytes)] {
      std::size_t written = 0;
      while (written < bytes.size()) {
        const ssize_t count = write(writer, bytes.data() + written, bytes.size() - written);
        if (count <= 0) break;
        written += static_cast<std::size_t>(count);
      }
      close(writer);
    });
  }
  ~Pipe() {
    close(reader_);
    thread_.join();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  std::string name() const { return "/dev/fd/" + std::to_string(reader_); }

 private:
  int reader_ = -1;
  std::thread thread_;
};

TEST(ReadStream, KnowsStreamsByTheirNames) {
  const TemporaryFolder folder;
  for (const char* const name : {"-", "/dev/stdin", "/dev/fd/0", "/proc/self/fd/9"}) {
    EXPECT_TRUE(is_stream(name)) << name;
  }
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(is_stream(folder / "pipe"));
  EXPECT_FALSE(is_stream(folder.write("file", "")));
  EXPECT_FALSE(is_stream(folder / "missing"));
  EXPECT_FALSE(is_stream("/dev/zero"));
  EXPECT_EQ(stream_name("-"), "standard input");
  EXPECT_EQ(stream_name("/dev/stdin"), "standard input");
  EXPECT_EQ(stream_name("/dev/fd/7"), "/dev/fd/7");
}

TEST(ReadStream, ReadsAPipeToItsEnd) {
  std::string bytes(1'000'003, 'x');
  bytes[65536] = '\0';
  EXPECT_EQ(read_stream(Pipe(bytes).name()), bytes);
  EXPECT_EQ(read_stream(Pipe("").name()), "");
}

TEST(ReadStream, ReadsAFileBehindAnOpenNumber) {
  const TemporaryFolder folder;
  const int number = open(folder.write("file", "abc").c_str(), O_RDONLY);
  EXPECT_EQ(read_stream("/dev/fd/" + std::to_string(number)), "abc");
  close(number);
}

TEST(ReadStream, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of(read_stream("/dev/fd/99999")), EndsWith("No such file or directory"));
  EXPECT_THAT(error_of(read_stream(folder.path())), EndsWith("cannot be read: Is a directory"));
  EXPECT_THAT(error_of(read_stream(Pipe("12345").name(), 4)),
              EndsWith("too large: the limit is 4 bytes"));
  EXPECT_EQ(read_stream(Pipe("1234").name(), 4), "1234");
}

TEST(WriteFile, WritesTheBytesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(write_file(folder / "file", bytes));
  EXPECT_EQ(bytes_of(folder / "file"), bytes);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, ReplacesAFile) {
  const TemporaryFolder folder;
  folder.write("file", "a long old text");
  ASSERT_TRUE(write_file(folder / "file", "new"));
  EXPECT_EQ(bytes_of(folder / "file"), "new");
}

/// Runs in its own process, because it limits the size of files to `limit` bytes.
void write_with_a_limit(const fs::path& file, const std::string& bytes, rlim_t limit) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit most{limit, limit};
  setrlimit(RLIMIT_FSIZE, &most);
  const auto written = write_file(file, bytes);
  std::_Exit(written ? 1 : 0);
}

TEST(WriteFile, LeavesTheOldFileWhereTheNewOneDoesNotFit) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  EXPECT_EXIT(write_with_a_limit(folder / "file", std::string(1'000'000, 'x'), 100'000),
              testing::ExitedWithCode(0), "");
  EXPECT_EQ(bytes_of(folder / "file"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, ReplacesTheFileAndDoesNotWriteIntoIt) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  std::ifstream reader(folder / "file");  // still reads what it opened
  ASSERT_TRUE(write_file(folder / "file", "new text"));
  std::string read;
  reader >> read;
  EXPECT_EQ(read, "old");
}

TEST(WriteFile, SaysWhyAFileCannotBeWritten) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(write_file(folder / "missing/file", "x")),
            (folder / "missing/file").string() + ": cannot be written: No such file or directory");
}

TEST(WriteFile, ReplacesTheTargetOfASymbolicLink) {
  const TemporaryFolder folder;
  folder.write("target", "old");
  fs::create_symlink(folder / "target", folder / "link");
  ASSERT_TRUE(write_file(folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(bytes_of(folder / "target"), "new");
}

TEST(WriteFile, MakesTheTargetOfASymbolicLinkThatHasNone) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "there");
  fs::create_symlink("there/second", folder / "first");
  fs::create_symlink("made", folder / "there/second");
  ASSERT_TRUE(write_file(folder / "first", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "first"));
  EXPECT_EQ(read_file(folder / "there/made"), "new");
  fs::create_symlink("loop", folder / "loop");
  EXPECT_FALSE(write_file(folder / "loop", "new"));
  EXPECT_TRUE(fs::is_symlink(folder / "loop"));
}

TEST(WriteFile, KeepsThePermissionsOfTheFileThatItReplaces) {
  const TemporaryFolder folder;
  for (const auto mode : {0600U, 0640U, 0444U, 0755U, 0666U}) {
    const auto file = folder.write("file", "old");
    const auto permissions = static_cast<fs::perms>(mode);
    fs::permissions(file, permissions);
    ASSERT_TRUE(write_file(file, "new"));
    EXPECT_EQ(fs::status(file).permissions(), permissions);
    EXPECT_EQ(read_file(file), "new");
    fs::remove(file);
  }
}

TEST(WriteFile, FollowsNoLinkThatSomebodyPutWhereATemporaryFileMayBe) {
  const TemporaryFolder folder;
  const auto victim = folder.write("victim", "precious");
  const std::string old_name = "file." + std::to_string(getpid()) + ".part";
  fs::create_symlink(victim, folder / old_name);
  ASSERT_TRUE(write_file(folder / "file", "new"));
  EXPECT_EQ(read_file(victim), "precious");
  EXPECT_FALSE(fs::is_symlink(folder / "file"));
  EXPECT_EQ(read_file(folder / "file"), "new");
}

TEST(WriteFile, WritesADeviceStraight) {
  ASSERT_TRUE(write_file("/dev/null", "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, RefusesAFolder) {
  const TemporaryFolder folder;
  EXPECT_FALSE(write_file(folder.path(), "x"));
  EXPECT_TRUE(fs::is_directory(folder.path()));
}

}  // namespace
}  // namespace wend
