#include "cli/output/output.hpp"

#include <fmt/format.h>

#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include "cli/arguments/flags.hpp"
#include "cli/exit_code.hpp"
#include "wend/io/files.hpp"
#include "wend/io/text.hpp"

namespace wend::cli {
namespace {

std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

void write_one(const std::string& file, const FileWriter& writer) {
  const std::string wrong = writer(file);
  if (!wrong.empty()) throw InputError(wrong);
}

}  // namespace

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written && errno == EPIPE) std::clearerr(stdout);  // the reader went away
}

void complain(std::string_view text) {
  std::fflush(stdout);
  // A progress bar may stand there.
  const std::string clear = isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "";
  const std::string line = clear + "wend: " + visible(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

bool finish_output() {
  const bool flushed = std::fflush(stdout) == 0;
  return flushed ? std::ferror(stdout) == 0 : errno == EPIPE;
}

void check_not_among(const std::vector<std::filesystem::path>& inputs,
                     const std::filesystem::path& file, const std::string& name) {
  for (const auto& input : inputs) {
    if (file == kStandardOutput) return;
    std::error_code error;  // a file that does not exist yet is not an input
    const auto& read = input == "-" ? std::filesystem::path("/dev/stdin") : input;
    if (!std::filesystem::equivalent(file, read, error)) continue;
    throw InputError(fmt::format(
        "{}: this file is also an input and would be overwritten; choose another name", name));
  }
}

void check_replaces_own(const std::filesystem::path& file, std::string_view beginning,
                        const std::string& name) {
  std::error_code error;
  if (file == kStandardOutput || !std::filesystem::is_regular_file(file, error)) return;
  auto content = FilePieces::open(file);
  if (!content || content->size() == 0 || content->next().starts_with(beginning)) return;
  throw InputError(fmt::format(
      "{}: this file exists and is not what the option writes; choose another name, or remove it",
      name));
}

void check_folder(const std::filesystem::path& file, const std::string& name) {
  const auto folder = file.parent_path();
  std::error_code error;
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: the folder {} does not exist", name, folder.string()));
  }
}

std::string write_bytes(const std::string& file, const std::string& bytes) {
  if (file == kStandardOutput) {
    cli::print(bytes);
    return {};
  }
  const auto written = write_file(file, bytes);
  return written ? std::string() : written.error().message;
}

void OutputFiles::add_to(Parser& app, std::vector<std::string> extensions, const std::string& help,
                         const std::string& printed) {
  extensions_ = std::move(extensions);
  may_print_ = !printed.empty();
  const std::string to_output =
      may_print_ ? fmt::format(". -o - writes only {} to standard output", printed) : "";
  add_texts(app, "-o,--output", files_, help + to_output).type_name(kFileType);
}

void OutputFiles::check() const {
  if (std::count(files_.begin(), files_.end(), kStandardOutput) > 1) {
    throw InputError("-o -: standard output can be written only once");
  }
  for (const std::string& file : files_) {
    if (may_print_ && file == kStandardOutput) continue;
    const std::string extension = extension_of(file);
    if (std::find(extensions_.begin(), extensions_.end(), extension) == extensions_.end()) {
      throw InputError(fmt::format("-o {}: the name must end in {}", file, or_list(extensions_)));
    }
    check_folder(file, "-o " + file);
  }
}

bool OutputFiles::print() const {
  return std::find(files_.begin(), files_.end(), kStandardOutput) != files_.end();
}

bool OutputFiles::is(const std::string& file, const std::string& extension) {
  return extension_of(file) == extension;
}

bool OutputFiles::any_of(const std::vector<std::string>& extensions) const {
  return std::any_of(extensions.begin(), extensions.end(),
                     [this](const std::string& extension) { return any(extension); });
}

bool OutputFiles::any(const std::string& extension) const {
  return std::any_of(files_.begin(), files_.end(), [&extension](const std::string& file) {
    return extension_of(file) == extension;
  });
}

bool OutputFiles::any_picture() const {
  return any(".png") || any(".svg") || any(".pdf") || any(".gif");
}

void OutputFiles::check_not_among(const std::vector<std::filesystem::path>& inputs) const {
  for (const std::string& file : files_) cli::check_not_among(inputs, file, "-o " + file);
}

void OutputFiles::write(const std::map<std::string, FileWriter>& writers,
                        const std::string& printed) const {
  for (const std::string& file : files_) {
    const auto writer = writers.find(file == kStandardOutput ? printed : extension_of(file));
    if (writer != writers.end()) write_one(file, writer->second);
  }
}

void OutputFiles::write_all(const FileWriter& writer) const {
  for (const std::string& file : files_) write_one(file, writer);
}

}  // namespace wend::cli
