#pragma once

// The engine that answers queries from the sections of a label index (hub_index.hpp).

#include <memory>

#include "wend/index/hub_labels/hub_sections.hpp"
#include "wend/index/index_engine.hpp"

namespace wend {

/// Keeps the bytes, where the sections lie.
std::unique_ptr<IndexEngine> make_hub_engine(IndexBytes index, const HubSections& sections,
                                             const BitGrid& passable);

}  // namespace wend
