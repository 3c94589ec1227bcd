#include "wend/io/read_stream.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

using testing::EndsWith;

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
              EndsWith("too many bytes, at most 4 are read"));
  EXPECT_EQ(read_stream(Pipe("1234").name(), 4), "1234");
}

}  // namespace
}  // namespace wend
