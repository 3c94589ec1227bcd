#pragma once

#include <string>

namespace wend {

/// What times depend on, without a name: "AMD EPYC, 2 cores; g++ 12.2.0".
std::string describe_machine();

}  // namespace wend
