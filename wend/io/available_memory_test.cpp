#include "wend/io/available_memory.hpp"

#include <gtest/gtest.h>

#include "wend/io/io_test_support.hpp"

namespace wend {
namespace {

namespace fs = std::filesystem;

/// A folder with files like those of Linux in / .
class AvailableMemory : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    root_.write(file, text);
  }

  std::optional<std::uint64_t> available() const { return available_memory(root_.path()); }

  TemporaryFolder root_;
};

TEST_F(AvailableMemory, IsUnknownWhereTheSystemSaysNothing) {
  EXPECT_EQ(available(), std::nullopt);
  write("proc/meminfo", "MemTotal: 100 kB\nMemFree: 50 kB\n");
  EXPECT_EQ(available(), std::nullopt);
}

TEST_F(AvailableMemory, IsWhatTheSystemHas) {
  write("proc/meminfo", "MemTotal:       1000 kB\nMemAvailable:    400 kB\n");
  EXPECT_EQ(available(), 400U * 1024);
}

TEST_F(AvailableMemory, IsWhatAControlGroupLeaves) {
  write("proc/meminfo", "MemAvailable: 400 kB\n");
  write("proc/self/cgroup", "0::/a/b\n");
  write("sys/fs/cgroup/a/memory.max", "300000\n");
  write("sys/fs/cgroup/a/memory.current", "250000\n");
  write("sys/fs/cgroup/a/memory.stat", "anon 1\nfile 100000\nfile_mapped 7\n");
  EXPECT_EQ(available(), 150000U) << "files make room";
  write("sys/fs/cgroup/a/b/memory.max", "max\n");
  write("sys/fs/cgroup/a/b/memory.current", "200000\n");
  EXPECT_EQ(available(), 150000U) << "an unlimited group inside";
  write("sys/fs/cgroup/a/b/memory.max", "200000\n");
  EXPECT_EQ(available(), 0U);
}

TEST_F(AvailableMemory, KnowsTheFirstVersionOfControlGroups) {
  write("proc/meminfo", "MemAvailable: 400 kB\n");
  write("proc/self/cgroup", "9:name=systemd:/\n4:memory:/docker/1f\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "300000\n");
  write("sys/fs/cgroup/memory/memory.usage_in_bytes", "200000\n");
  EXPECT_EQ(available(), 100000U) << "in a container its own group is the outermost";
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(available(), 400U * 1024) << "no limit";
}

TEST_F(AvailableMemory, OfThisMachineIsMoreThanNothing) {
  const auto here = available_memory();
  if (!here) GTEST_SKIP() << "the system does not say";
  EXPECT_GT(*here, 0U);
}

}  // namespace
}  // namespace wend
