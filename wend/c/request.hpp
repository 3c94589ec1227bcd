#pragma once

// Requests of the C interface: a structure whose fields are those of request_fields(), by member or by name.

#include <cstddef>
#include <string>
#include <vector>

#include "wend/c/boundary.hpp"
#include "wend/session/plan_request.hpp"
#include "wend/wend.h"

namespace wend::c {

/// What a caller asks on a map of that resolution. Fails for what is not valid or not complete; `closed`: it must have no
/// goals, else one or more.
Expected<PlanRequest, Failure> request_of(const wend_request* given, double resolution,
                                          bool closed = false);

/// Poses as goals or vias; NaN is any heading. `name` is what messages call them.
Expected<std::vector<MapGoal>, Failure> places_of(const wend_pose* poses, std::size_t count,
                                                  const std::string& name);

}  // namespace wend::c
