#pragma once

// Pictures as files: the writers for -o that every command with pictures has.

#include <map>
#include <string>
#include <vector>

#include "cli/output/output_files.hpp"
#include "wend/render/picture/panels.hpp"
#include "wend/render/style.hpp"

namespace wend::cli {

/// What pictures can be written as.
std::vector<std::string> picture_extensions();

/// Writers that draw the panels side by side; they copy what they are given.
std::map<std::string, FileWriter> picture_writers(std::vector<Panel> panels, StyleName style);

/// Writes a picture, if it could be drawn; what went wrong, empty if nothing did.
std::string write_picture(const std::string& file,
                          const Expected<std::string, RenderError>& picture);

}  // namespace wend::cli
