#include "wend/report/build_info.hpp"

#include "wend/version.hpp"

namespace wend {

std::string_view wend_version() { return WEND_VERSION; }

}  // namespace wend
