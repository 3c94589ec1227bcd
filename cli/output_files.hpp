#pragma once

// -o FILE: results as files, each in the format that its name asks for.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "parser.hpp"

namespace wend::cli {

/// Writes a file; what went wrong, empty if nothing did.
using FileWriter = std::function<std::string(const std::string& file)>;

/// Throws InputError if a file that is about to be written is one of `inputs`: the map would be
/// lost. `name` is what the message calls it.
void check_not_among(const std::vector<std::filesystem::path>& inputs,
                     const std::filesystem::path& file, const std::string& name);

/// Throws InputError if a file is to lie in a folder that is not there.
void check_folder(const std::filesystem::path& file, const std::string& name);

/// Writes text or bytes; what went wrong, empty if nothing did.
std::string write_bytes(const std::string& file, const std::string& bytes);

class OutputFiles {
 public:
  /// -o, once for each file. `extensions` are those that the command can write: {".png", ".csv"}.
  void add_to(Parser& app, std::vector<std::string> extensions, const std::string& help);

  /// Throws InputError for a name that no writer will take and for a folder that is not there.
  void check() const;

  /// The same for each of these files.
  void check_not_among(const std::vector<std::filesystem::path>& inputs) const;

  /// Calls the writer of each file's extension. A file whose extension has no writer now is left
  /// out. Throws InputError if one cannot be written.
  void write(const std::map<std::string, FileWriter>& writers) const;

  /// One writer for every file.
  void write_all(const FileWriter& writer) const;

  const std::vector<std::string>& files() const { return files_; }

  /// Is there a file with that extension?
  bool any(const std::string& extension) const;

  /// Is there a picture or a film?
  bool any_picture() const;

 private:
  std::vector<std::string> extensions_;
  std::vector<std::string> files_;
};

}  // namespace wend::cli
