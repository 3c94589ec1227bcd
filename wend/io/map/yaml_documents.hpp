#pragma once

// How many documents a YAML text has.

#include <string>

namespace wend {

/// 0 or 1, or 2 for more than one. Throws YAML::Exception for what is no YAML. YAML::LoadAll()
/// cannot be asked: on a stray ',' at the top level it makes documents for ever.
int yaml_documents(const std::string& text);

}  // namespace wend
