#pragma once

// plan_tour(): the best order of many stops, by what the ways between them cost.
//
//   wend::CostMatrix costs(4, 10.0);
//   costs.set(2, 1, 3.0);  // from stop 2 to stop 1
//   const auto tour = wend::plan_tour(costs, {.start = 0});
//   if (!tour) return report(tour.error().message);
//   for (const int stop : tour->order) drive_to(stop);
//
// Up to 12 stops the order is the best (dynamic programming). For more, it is a local search: changes of up to three
// legs that pay (Lin and Kernighan), and kicks: a random change nearby, which is taken back unless the search
// makes it as good as before. On 1,000 stops of a warehouse the order is within 1 % of the best after 20 kicks
// a stop. The bound is that of Held and Karp: no order is cheaper.
//
// It is our own: LKH may not be used commercially, and OR-tools is not in Debian.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "wend/base/compiler.hpp"
#include "wend/base/error.hpp"
#include "wend/base/expected.hpp"
#include "wend/base/limits.hpp"
#include "wend/base/status.hpp"
#include "wend/tour/cost_matrix.hpp"

namespace wend {

/// Two stops, by their rows in the matrix.
struct StopPair {
  int first;
  int second;

  friend bool operator==(const StopPair&, const StopPair&) = default;
};

/// What an order must obey, and how long to look for a good one.
struct TourOptions {
  bool closed = false;                // return to the first stop; its cost is part of the tour's
  std::optional<int> start = {};      // the first stop; unset: any (closed tours: stop 0)
  std::optional<int> end = {};        // the last stop; unset: any. Not for closed tours
  std::vector<StopPair> before = {};  // `first` must come somewhere before `second`
  std::vector<StopPair> fixed =
      {};  // must follow each other directly, in either order: the ends of a swath
  std::optional<std::uint64_t> kicks =
      {};                  // unset: 20 a stop; with a limit on time as many as it allows
  bool bound = true;       // also compute Tour::bound; else it is 0 beyond 12 stops
  std::uint64_t seed = 1;  // the same seed and number of kicks give the same order
  Limits limits = {};      // `seconds`, `clock` and `cancel`; the best order so far is the answer
  /// Is told every better order, its cost first. Null: nobody.
  std::function<void(double cost, std::span<const int> order)> improved = {};
};

/// An order of all stops.
struct Tour {
  std::vector<int> order;   // rows of the matrix; a closed tour does not repeat the first
  double cost = 0;          // of all legs, in the matrix's unit
  double bound = 0;         // no order that obeys the options costs less (up to rounding of sums)
  std::uint64_t kicks = 0;  // that were tried
  Status status =
      Status::found;  // time_limit, cancelled: the search for a better order was cut short
};

/// The order. Fails with invalid_option for options that contradict each other or name stops that the matrix has
/// not, or costs that are negative, NaN or above 1e150; with unreachable if no order was found whose legs all have a finite cost; with
/// time_limit or cancelled if there was no time for a first order. For up to some thousand stops: memory and the time
/// for the first order are O(stops^2).
WEND_API Expected<Tour, Error> plan_tour(const CostMatrix& costs, const TourOptions& options = {});

}  // namespace wend
