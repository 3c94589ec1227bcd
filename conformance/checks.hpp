#pragma once

// The checks of the suite, in groups. Each function runs the trial of one seed.

#include <cstdint>
#include <string>

#include "conformance/examination.hpp"

namespace wend::test {

// cell_checks.cpp: against the reference.
void examine_cell_answers(Examination& examination, std::uint64_t seed);
void examine_nine_cells(Examination& examination, std::uint64_t bits);
void examine_mirrored(Examination& examination, std::uint64_t seed);
void examine_y_up(Examination& examination, std::uint64_t seed);
void examine_start_is_goal(Examination& examination, std::uint64_t seed);
/// Enough paths were found to say anything.
void conclude_answers(Examination& examination);

// anytime_checks.cpp: what anytime planners tell, against the reference.
void examine_anytime(Examination& examination, std::uint64_t seed);

// pose_checks.cpp: without knowing the motions.
void examine_pose_answers(Examination& examination, std::uint64_t seed);

// repetition_checks.cpp: the same answer in another way.
void examine_reused(Examination& examination, std::uint64_t seed);
void examine_updated(Examination& examination, std::uint64_t seed);
void examine_edited(Examination& examination, std::uint64_t seed);
void examine_cloned(Examination& examination, std::uint64_t seed);
void examine_stepped(Examination& examination, std::uint64_t seed);

// query_checks.cpp: what ends a query early.
void examine_status(Examination& examination, std::uint64_t seed);
void examine_limits(Examination& examination, std::uint64_t seed);
void examine_terrain(Examination& examination, std::uint64_t seed);

/// What a failure must not leave in a plan; empty if nothing is wrong.
std::string leftover_of(const Plan& plan);

}  // namespace wend::test
