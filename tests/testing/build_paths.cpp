#include "tests/testing/build_paths.hpp"

#ifndef WEND_CLI_PATH
#define WEND_CLI_PATH "wend"
#endif
#ifndef WEND_PLANNER_PAGE_PATH
#define WEND_PLANNER_PAGE_PATH ""
#endif
#ifndef WEND_PLUGINS
#define WEND_PLUGINS ""
#endif

namespace wend::test {

std::filesystem::path data_folder() { return WEND_DATA; }
std::filesystem::path source_folder() { return WEND_SOURCE_DIR; }
std::string program() { return WEND_CLI_PATH; }
std::string planner_page_program() { return WEND_PLANNER_PAGE_PATH; }
std::filesystem::path plugin_folder() { return WEND_PLUGINS; }

}  // namespace wend::test
