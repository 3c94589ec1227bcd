#pragma once

// The list of what front ends set of a PlanRequest by name.
//
//   wend::PlanRequest request{{1, 1, 0}, {{{15, 9}}}};
//   const wend::RequestField* const escape = wend::request_field("escape");
//   const auto set = escape->set(request, 0.5, map.frame().resolution);
//
// A new field is a member of PlanRequest and an entry of this list.

#include <span>
#include <string_view>

#include "wend/base/compiler.hpp"
#include "wend/base/field.hpp"
#include "wend/session/plan_request.hpp"

namespace wend {

/// A field of a request, see Field. It is set in a request whose goals are known.
using RequestField = Field<PlanRequest>;

/// All fields, in the order in which front ends show them.
WEND_API std::span<const RequestField> request_fields();

/// The field of that name or alias, or null.
WEND_API const RequestField* request_field(std::string_view name);

}  // namespace wend
