#pragma once

// The moves of a drive as a list for people: equal moves that follow each other are one line.
//
//   for (const wend::RepeatedMove& move : wend::merged_moves(plan.moves)) {
//     lines.push_back("Go " + wend::text_of(move));  // "Go FWD_RIGHT", "Go 3 x FWD"
//   }

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wend {

/// A move that is made once or several times in a row.
struct RepeatedMove {
  std::string_view name;  // "FWD"
  std::size_t times = 1;  // how often
  std::size_t end =
      1;  // the number of moves up to the last of these: the place of its last pose in the path
};

/// Merges equal moves that follow each other; the names must outlive the result. O(moves).
inline std::vector<RepeatedMove> merged_moves(std::span<const std::string_view> moves) {
  std::vector<RepeatedMove> merged;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (merged.empty() || merged.back().name != moves[i]) {
      merged.push_back({moves[i], 1, i + 1});
    } else {
      ++merged.back().times;
      merged.back().end = i + 1;
    }
  }
  return merged;
}

/// "FWD", "3 x FWD".
inline std::string text_of(const RepeatedMove& move) {
  const std::string name(move.name);
  return move.times > 1 ? std::to_string(move.times) + " x " + name : name;
}

}  // namespace wend
