#pragma once

// PseudoTerminal: the program on a terminal of its own, typed at and read.

#include <pty.h>
#include <sys/ioctl.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/testing/build_paths.hpp"
namespace wend::test {

class PseudoTerminal {
 public:
  PseudoTerminal(int columns, int rows) {
    const winsize size{static_cast<unsigned short>(rows), static_cast<unsigned short>(columns), 0,
                       0};
    if (openpty(&ours_, &its_, nullptr, nullptr, &size) != 0) throw std::runtime_error("openpty");
  }
  ~PseudoTerminal() { close(ours_); }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), program());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    child_ = fork();
    if (child_ != 0) {
      close(its_);  // the program alone holds it: reading ends when the program does
      return;
    }
    unsetenv("NO_COLOR");
    setenv("TERM", "xterm-256color", 1);
    close(ours_);
    login_tty(its_);
    execv(arguments.front().c_str(), pointers.data());
    _exit(127);
  }

  void type(const std::string& keys) const {
    if (write(ours_, keys.data(), keys.size()) < 0) throw std::runtime_error("write");
  }

  /// Of what is written from now on; until the text comes or the program ends.
  void read_until(const std::string& text) {
    const std::size_t from = seen_.size();
    while (seen_.find(text, from) == std::string::npos) {
      if (!read_more()) throw std::runtime_error("the program ended before it wrote " + text);
    }
  }

  /// Waits for the program to end; its exit code, or -1 where a signal ended it.
  int finish() {
    while (read_more()) {
    }
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  const std::string& seen() const { return seen_; }

  /// How it takes keys and shows what is written.
  termios settings() const {
    termios settings{};
    tcgetattr(ours_, &settings);
    return settings;
  }

 private:
  bool read_more() {
    std::array<char, 4096> bytes;
    const ssize_t count = read(ours_, bytes.data(), bytes.size());
    if (count <= 0) return false;
    seen_.append(bytes.data(), static_cast<std::size_t>(count));
    return true;
  }

  int ours_ = -1;
  int its_ = -1;
  pid_t child_ = 0;
  std::string seen_;
};

}  // namespace wend::test
