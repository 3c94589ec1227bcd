#include "cli/output/output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

namespace wend::cli {

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written && errno == EPIPE) std::clearerr(stdout);  // the reader went away
}

void complain(std::string_view text) {
  std::fflush(stdout);
  // A progress bar may stand there.
  const std::string clear = isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "";
  const std::string line = clear + "wend: " + std::string(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

bool finish_output() {
  const bool flushed = std::fflush(stdout) == 0;
  return flushed ? std::ferror(stdout) == 0 : errno == EPIPE;
}

}  // namespace wend::cli
