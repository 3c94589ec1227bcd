#pragma once

// FailureText: makes sentences of the causes of a failure.

#include <string>
#include <string_view>
#include <vector>

#include "wend/base/status.hpp"
#include "wend/planner/failure.hpp"
#include "wend/robot/free_space.hpp"
#include "wend/session/failure_text.hpp"
#include "wend/session/units.hpp"

namespace wend {

/// The ends of a query as its planner names them: cells, or "(0.1,0.05,S) m" of a planner with headings.
Ends ends_of(const Failure& failure, const Units& units);

/// Words what is so.
class FailureText {
 public:
  /// Of failures in this space, which must live as long.
  FailureText(const FreeSpace& space, const Units& units, const Hints& hints)
      : space_(space), units_(units), hints_(hints) {}

  /// All causes, and what the goals' tolerances have to do with them; `ends` as ends_of().
  std::string of(const Failure& failure, const Ends& ends, const SearchMetrics& metrics) const;

  /// One cause.
  std::string of(const FailureCause& cause, const Failure& failure, const Ends& ends,
                 const SearchMetrics& metrics) const;

  /// "the start (3,4) is outside the map, which covers ..."
  std::string outside(const Place& place, bool on_corners) const;

  /// Why a search was stopped: "stopped after 1000 expansions"; for other statuses, what they mean.
  std::string stopped(Status status, const Stopped& limits, const SearchMetrics& metrics) const;

  /// ". The robot fits nowhere within its tolerance of 2 cells"; empty if the failure is not about a goal, or there is
  /// no tolerance.
  std::string tolerance(const Failure& failure) const;

 private:
  std::string of(const EndBlocked& blocked, const Failure& failure, const Ends& ends) const;
  std::string of(const RobotTooLarge& robot) const;
  std::string of(const NoDriveFound& why, const Ends& ends) const;
  std::string of(const InvalidQuery& invalid) const;
  std::string why(const EndBlocked& blocked, const Failure& failure) const;
  std::string cell_of(const EndBlocked& blocked, const Failure& failure) const;
  std::string too_near(const EndBlocked& blocked, const Failure& failure,
                       std::string_view obstacle) const;
  std::string size(double width, double height) const;

  const FreeSpace& space_;
  const Units& units_;
  const Hints& hints_;
};

/// "--escape 0.5", or "escape=0.5".
std::string with_value(const std::string& hint, const std::string& value);

/// " (--unknown free)"; empty for an empty hint.
std::string in_brackets(const std::string& hint, const std::string& value = {});

/// All texts in one.
std::string joined_texts(const std::vector<std::string>& texts, std::string_view separator);

}  // namespace wend
