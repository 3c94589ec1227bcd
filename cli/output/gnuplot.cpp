#include "cli/output/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/exit_code.hpp"

namespace wend::cli {
namespace {

/// An unnamed file that is removed automatically. Unlike pipes, files cannot make two programs wait
/// for each other.
class ScratchFile {
 public:
  ScratchFile() : file_(std::tmpfile()) {
    if (!file_) throw InputError("--plot: cannot create a temporary file");
  }

  int descriptor() const { return fileno(file_.get()); }

  /// Writes a text, to be read by somebody else from its beginning.
  void put(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), file_.get());
    to_the_beginning();
  }

  std::string text() {
    to_the_beginning();
    std::string text;
    std::array<char, 65536> block{};
    for (std::size_t got = 1; got > 0;) {
      got = std::fread(block.data(), 1, block.size(), file_.get());
      text.append(block.data(), got);
    }
    return text;
  }

 private:
  /// Flushes and rewinds, also for a process that shares the descriptor.
  void to_the_beginning() {
    if (std::fseek(file_.get(), 0, SEEK_SET) != 0) {
      throw InputError("--plot: cannot write a temporary file");
    }
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

/// Runs gnuplot with a script on its standard input. Returns its exit status, or nothing if there
/// is no such program.
std::optional<int> run_gnuplot(ScratchFile& script, ScratchFile& output, ScratchFile& complaints) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::array<std::pair<int, int>, 3> streams{{{script.descriptor(), STDIN_FILENO},
                                                    {output.descriptor(), STDOUT_FILENO},
                                                    {complaints.descriptor(), STDERR_FILENO}}};
  for (const auto& [from, to] : streams) posix_spawn_file_actions_adddup2(&actions, from, to);
  std::string name = "gnuplot";
  std::string from_input = "-";
  const std::array<char*, 3> words{name.data(), from_input.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, name.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

PlotKind plot_kind_of(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".png") return PlotKind::png;
  if (extension == ".svg") return PlotKind::svg;
  if (extension == ".pdf") return PlotKind::pdf;
  throw InputError(fmt::format("--plot {}: the name must end in .png, .svg or .pdf", file));
}

PlotColours plot_colours_of(StyleName style) {
  switch (style) {
    case StyleName::light:
      return kLightPlot;
    case StyleName::dark:
      return kDarkPlot;
    case StyleName::print:
      return kPrintPlot;
  }
  return kLightPlot;
}

void require_gnuplot() { drawn_by_gnuplot("exit\n"); }

std::string drawn_by_gnuplot(const std::string& script) {
  ScratchFile input;
  ScratchFile output;
  ScratchFile complaints;
  input.put(script);
  const auto status = run_gnuplot(input, output, complaints);
  if (!status) {
    throw InputError(
        "--plot needs the program gnuplot (Debian package gnuplot-nox), which is not installed");
  }
  if (*status != 0) throw InputError("--plot: gnuplot says: " + complaints.text());
  return output.text();
}

}  // namespace wend::cli
