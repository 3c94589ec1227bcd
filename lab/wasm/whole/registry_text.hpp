#pragma once

// The registries as JSON: what the menus of the page are made of.

#include <string>

namespace wend::lab {

/// {"version", "planners": [...], "generators": [...], "smoothers": [...], "controllers": [...]}, each with its options.
std::string registry_text();

}  // namespace wend::lab
