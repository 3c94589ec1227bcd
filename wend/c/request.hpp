#pragma once

// Requests of the C interface: a structure whose fields are those of request_fields(), by member or by name.

#include "wend/c/boundary.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/wend.h"

namespace wend::c {

/// What a caller asks on a map of that resolution. Fails for what is not valid or not complete.
Expected<PlanRequest, Failure> request_of(const wend_request* given, double resolution);

}  // namespace wend::c
