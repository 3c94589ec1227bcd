#pragma once

// Output of subcommands: results on standard output, messages on standard error, and files (-o).

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cli/arguments/parser.hpp"

namespace wend::cli {

/// Writes a result. Errors show in finish_output().
void print(std::string_view text);

/// Writes a line for people to standard error: "wend: <text>".
void complain(std::string_view text);

/// Writes the buffered output. False if results were lost. A reader that closed the pipe
/// (`wend ... | head`) is not an error.
bool finish_output();

/// Writes a file. Returns the error message, empty on success.
using FileWriter = std::function<std::string(const std::string& file)>;

/// Throws InputError if there is a file of this name that does not begin with `beginning`, as those that this option
/// writes do: it is something else, and would be lost. `name` is what the message calls it.
void check_replaces_own(const std::filesystem::path& file, std::string_view beginning,
                        const std::string& name);

/// Throws InputError if a file that is about to be written is one of `inputs`: the map would be
/// lost. `name` is what the message calls it.
void check_not_among(const std::vector<std::filesystem::path>& inputs,
                     const std::filesystem::path& file, const std::string& name);

/// Throws InputError if the folder of a file does not exist.
void check_folder(const std::filesystem::path& file, const std::string& name);

/// The name that stands for standard output.
inline constexpr std::string_view kStandardOutput = "-";

/// Writes text or bytes to a file, or to standard output if that is the name. Returns the error message,
/// empty on success.
std::string write_bytes(const std::string& file, const std::string& bytes);

class OutputFiles {
 public:
  /// -o, once for each file. `extensions` are those that the command can write: {".png", ".csv"}.
  /// With `printed` a file may be standard output, in the format of --format, and `printed` says in
  /// help what then comes out: "the path".
  void add_to(Parser& app, std::vector<std::string> extensions, const std::string& help,
              const std::string& printed = {});

  /// Throws InputError for a name that no writer accepts and for a missing folder.
  void check() const;

  /// The same for each of these files.
  void check_not_among(const std::vector<std::filesystem::path>& inputs) const;

  /// Is one of them standard output? Then nothing else may be written to it.
  bool print() const;

  /// Calls the writer of each file's extension, for standard output that of `printed`. A file whose
  /// extension has no writer now is left out. Throws InputError if one cannot be written.
  void write(const std::map<std::string, FileWriter>& writers,
             const std::string& printed = {}) const;

  /// One writer for every file.
  void write_all(const FileWriter& writer) const;

  const std::vector<std::string>& files() const { return files_; }

  /// Has a file's name this extension?
  static bool is(const std::string& file, const std::string& extension);

  /// Is there a file with one of these extensions?
  bool any_of(const std::vector<std::string>& extensions) const;

  /// Is there a file with that extension?
  bool any(const std::string& extension) const;

  /// Is there a picture or a film?
  bool any_picture() const;

 private:
  std::vector<std::string> extensions_;
  bool may_print_ = false;
  std::vector<std::string> files_;
};

}  // namespace wend::cli
