#pragma once

// What the build tells the tests: folders and programs. Only build_paths.cpp is compiled with these paths, so that a
// compiler cache knows all other objects of another clone.

#include <filesystem>
#include <string>

namespace wend::test {

/// The folder with real maps and scenarios; empty: there is none.
std::filesystem::path data_folder();

/// The root of the source tree.
std::filesystem::path source_folder();

/// The program wend: the one of the build, else the installed one.
std::string program();

/// The program wend-planner-page; empty: it was not built.
std::string planner_page_program();

/// The folder with the plugins of tests/plugins; empty: they were not built.
std::filesystem::path plugin_folder();

}  // namespace wend::test
