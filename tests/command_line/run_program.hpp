#pragma once

// Runs a program as a shell would and keeps what it wrote.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "tests/testing/build_paths.hpp"
namespace wend::test {

struct Outcome {
  int code = -1;   // of the exit
  int signal = 0;  // that ended it; 0: it exited
  std::string out;
  std::string err;
};

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A folder that is there for one test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = testing::TempDir() + "wend_command_line_XXXXXX";
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(std::string_view file) const { return path_ / file; }

  std::string write(std::string_view file, std::string_view bytes) const {
    std::ofstream(path_ / file, std::ios::binary) << bytes;
    return path_ / file;
  }

 private:
  std::filesystem::path path_;
};

inline std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// How a child that has been waited for ended.
inline void set_end(Outcome& outcome, int wait_status) {
  if (WIFEXITED(wait_status)) outcome.code = WEXITSTATUS(wait_status);
  if (WIFSIGNALED(wait_status)) outcome.signal = WTERMSIG(wait_status);
}

/// arguments[0] is the program; nothing comes from standard input. `environment` is added to ours.
inline Outcome run_program(std::vector<std::string> arguments,
                           std::vector<std::string> environment = {}) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const std::string err = folder / "err";
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0600);
  for (char** variable = environ; *variable != nullptr; ++variable) {
    environment.emplace_back(*variable);
  }
  pid_t child = 0;
  int wait_status = 0;
  Outcome outcome;
  if (posix_spawnp(&child, arguments[0].c_str(), &actions, nullptr, pointers_to(arguments).data(),
                   pointers_to(environment).data()) == 0 &&
      waitpid(child, &wait_status, 0) == child) {
    set_end(outcome, wait_status);
  }
  posix_spawn_file_actions_destroy(&actions);
  outcome.out = bytes_of(out);
  outcome.err = bytes_of(err);
  return outcome;
}

/// The program wend.
inline Outcome wend(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), program());
  return run_program(std::move(arguments));
}

/// A line of sh in which $WEND is the program.
inline Outcome shell(const std::string& line) {
  return run_program({"/bin/sh", "-c", line}, {"WEND=" + program()});
}

}  // namespace wend::test
