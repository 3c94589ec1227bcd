#include "wend/tour/order_search.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "wend/base/random.hpp"
#include "wend/tour/whole_costs.hpp"

namespace wend {
namespace {

constexpr int kDeepest = 3;  // edges of a change
constexpr std::array<int, kDeepest> kBreadth = {0, 7,
                                                5};  // neighbours tried for the edge of each depth
constexpr int kNearest = 7;
constexpr int kLongestPiece = 30;  // that a kick moves

using Sum = std::int64_t;

/// A neighbour of a node, and the cost of their edge.
struct Near {
  int node;
  WholeCost cost;
};

/// Edges to remove from a tour, and those that then join them: nodes 2i and 2i + 1 are an edge of the tour, nodes
/// 2i + 1 and 2i + 2 are joined, and so are the last and the first.
struct Change {
  int edges = 0;
  std::array<int, 2 * kDeepest> nodes = {};
};

/// A piece of the tour between two removed edges, and how it is passed afterwards.
struct Piece {
  int first;  // positions, inclusive, cyclic
  int last;
  bool reversed;
};

constexpr int kMostPieces = 4;  // a kick makes four
using Pieces = std::array<Piece, kMostPieces>;

/// A ring of nodes in an array, with a log of what was written.
class Ring {
 public:
  explicit Ring(std::vector<int> nodes) : nodes_(std::move(nodes)), position_(nodes_.size()) {
    for (int at = 0; at < size(); ++at) position_[static_cast<std::size_t>(node(at))] = at;
  }

  int size() const { return static_cast<int>(nodes_.size()); }
  int node(int position) const { return nodes_[static_cast<std::size_t>(position)]; }
  int position(int node) const { return position_[static_cast<std::size_t>(node)]; }
  int next(int of) const {
    const int at = position(of) + 1;
    return node(at == size() ? 0 : at);
  }
  int previous(int of) const {
    const int at = position(of);
    return node(at == 0 ? size() - 1 : at - 1);
  }
  int wrapped(int position) const { return position >= size() ? position - size() : position; }

  /// Passes the pieces, which are all of the ring, in this order. O(size - longest piece).
  void arrange(const Pieces& pieces, int count) {
    int longest = 0;
    for (int i = 1; i < count; ++i) {
      if (length(at(pieces, i)) > length(at(pieces, longest))) longest = i;
    }
    // The longest piece stays. If it were reversed, all is read from behind.
    const bool mirrored = at(pieces, longest).reversed;
    written_.clear();
    for (int i = 1; i < count; ++i) {
      Piece piece = at(pieces, (longest + (mirrored ? count - i : i)) % count);
      piece.reversed = piece.reversed != mirrored;
      copy(piece);
    }
    int to = wrapped(at(pieces, longest).last + 1);
    for (const int node : written_) {
      write(to, node);
      to = wrapped(to + 1);
    }
  }

  std::size_t log_size() const { return log_.size(); }
  void forget_log() { log_.clear(); }
  /// Takes back what was written since the log had this size.
  void undo(std::size_t log_size) {
    while (log_.size() > log_size) {
      const auto [at, node] = log_.back();
      log_.pop_back();
      put(at, node);
    }
  }

 private:
  static const Piece& at(const Pieces& pieces, int i) {
    return pieces[static_cast<std::size_t>(i)];
  }

  int length(const Piece& piece) const {
    const int steps = piece.last - piece.first;
    return (steps < 0 ? steps + size() : steps) + 1;
  }

  void copy(const Piece& piece) {
    int from = piece.reversed ? piece.last : piece.first;
    for (int left = length(piece); left > 0; --left) {
      written_.push_back(node(from));
      if (piece.reversed) {
        from = from == 0 ? size() - 1 : from - 1;
      } else {
        from = wrapped(from + 1);
      }
    }
  }

  void write(int at, int node) {
    if (nodes_[static_cast<std::size_t>(at)] == node) return;
    log_.emplace_back(at, nodes_[static_cast<std::size_t>(at)]);
    put(at, node);
  }

  void put(int at, int node) {
    nodes_[static_cast<std::size_t>(at)] = node;
    position_[static_cast<std::size_t>(node)] = at;
  }

  std::vector<int> nodes_;
  std::vector<int> position_;
  std::vector<int> written_;
  std::vector<std::pair<int, int>> log_;
};

/// What a change makes of a ring: its pieces in their new order; 0 pieces if that is more than one ring.
int pieces_after(const Ring& ring, const Change& change, Pieces& pieces) {
  // An end of a removed edge is numbered by the edge's rank in the ring, twice; plus 1 if it is the later one.
  std::array<int, kDeepest> begins = {};  // where removed edges are, ascending
  std::array<int, kDeepest> edge_at = {};
  const int edges = change.edges;
  const auto node = [&](int i) { return change.nodes[static_cast<std::size_t>(i)]; };
  for (int edge = 0; edge < edges; ++edge) {
    const int a = ring.position(node(2 * edge));
    const int b = ring.position(node(2 * edge + 1));
    const int begin = ring.wrapped(a + 1) == b ? a : b;
    int slot = edge;
    for (; slot > 0 && begins[static_cast<std::size_t>(slot - 1)] > begin; --slot) {
      begins[static_cast<std::size_t>(slot)] = begins[static_cast<std::size_t>(slot - 1)];
      edge_at[static_cast<std::size_t>(slot)] = edge_at[static_cast<std::size_t>(slot - 1)];
    }
    begins[static_cast<std::size_t>(slot)] = begin;
    edge_at[static_cast<std::size_t>(slot)] = edge;
  }
  std::array<int, 2 * kDeepest> end_of = {};  // of a node of the change: which end of which edge
  std::array<int, 2 * kDeepest> node_at = {};
  for (int rank = 0; rank < edges; ++rank) {
    const int edge = edge_at[static_cast<std::size_t>(rank)];
    const bool first_begins =
        ring.position(node(2 * edge)) == begins[static_cast<std::size_t>(rank)];
    const int begin = first_begins ? 2 * edge : 2 * edge + 1;
    end_of[static_cast<std::size_t>(begin)] = 2 * rank;
    end_of[static_cast<std::size_t>(begin ^ 1)] = 2 * rank + 1;
    node_at[static_cast<std::size_t>(2 * rank)] = begin;
    node_at[static_cast<std::size_t>(2 * rank + 1)] = begin ^ 1;
  }
  const int ends = 2 * edges;
  const auto joined = [&](int end) {  // across the new edge
    const int i = node_at[static_cast<std::size_t>(end)];
    const int other = (i & 1) != 0 ? (i + 1 == ends ? 0 : i + 1) : (i == 0 ? ends - 1 : i - 1);
    return end_of[static_cast<std::size_t>(other)];
  };
  const auto position = [&](int end) {
    const int begin = begins[static_cast<std::size_t>(end / 2)];
    return (end & 1) != 0 ? ring.wrapped(begin + 1) : begin;
  };
  int count = 0;
  int at = 1;  // the piece behind the first removed edge, at its beginning
  do {
    const bool reversed = (at & 1) == 0;
    const int across = reversed ? (at == 0 ? ends - 1 : at - 1) : (at + 1 == ends ? 0 : at + 1);
    pieces[static_cast<std::size_t>(count)] = reversed
                                                  ? Piece{position(across), position(at), true}
                                                  : Piece{position(at), position(across), false};
    ++count;
    at = joined(across);
  } while (at != 1 && count < edges);
  return at == 1 && count == edges ? count : 0;
}

/// Nodes to look at, each once.
class WorkList {
 public:
  explicit WorkList(int nodes) : listed_(static_cast<std::size_t>(nodes), 0) {}

  bool empty() const { return nodes_.empty(); }
  void add(int node) {
    char& listed = listed_[static_cast<std::size_t>(node)];
    if (listed == 0) nodes_.push_back(node);
    listed = 1;
  }
  int take() {
    const int node = nodes_.back();
    nodes_.pop_back();
    listed_[static_cast<std::size_t>(node)] = 0;
    return node;
  }

 private:
  std::vector<int> nodes_;
  std::vector<char> listed_;
};

template <class Costs>
class Search final : public OrderSearch {
 public:
  Search(const OrderProblem& problem, const std::vector<int>& order, std::uint64_t seed)
      : problem_(problem),
        cost_(problem),
        ring_(nodes_of(problem, order)),
        work_(ring_.size()),
        random_(seed) {
    list_nearest();
  }

  void settle() override {
    for (int at = 0; at < ring_.size(); ++at) work_.add(ring_.node(at));
    work_off();
    ring_.forget_log();
  }

  bool kick() override {
    const Sum paid = disturb();
    if (paid == kNotDisturbed) return false;
    const Sum gained = work_off() - paid;
    if (gained < 0) ring_.undo(0);
    ring_.forget_log();
    return gained > 0;
  }

  std::vector<int> order() const override {
    const int size = ring_.size();
    const int begin = ring_.position(problem_.first * Costs::kNodesOfPlace);
    const bool forward = reads(true);
    std::vector<int> order;
    for (int i = 0; i < size; ++i) {
      const int at = forward ? ring_.wrapped(begin + i) : ring_.wrapped(begin - i + size);
      const int node = ring_.node(at);
      const int place = node / Costs::kNodesOfPlace;
      const bool repeated = Costs::kNodesOfPlace == 2 && (node & 1) != 0;
      if (!repeated && place < problem_.stops) order.push_back(place);
    }
    return order;
  }

 private:
  static constexpr Sum kNotDisturbed = std::numeric_limits<Sum>::min();

  static std::vector<int> nodes_of(const OrderProblem& problem, const std::vector<int>& order) {
    std::vector<int> nodes;
    const auto add = [&](int place) {
      for (int i = 0; i < Costs::kNodesOfPlace; ++i)
        nodes.push_back(place * Costs::kNodesOfPlace + i);
    };
    if (!problem.closed) add(problem.first);
    for (const int stop : order) add(stop);
    return nodes;
  }

  void list_nearest() {
    const int size = ring_.size();
    std::vector<Near> all;
    near_.resize(static_cast<std::size_t>(size));
    for (int node = 0; node < size; ++node) {
      all.clear();
      for (int other = 0; other < size; ++other) {
        const WholeCost cost = cost_(node, other);
        if (other != node && cost < kNoWholeCost && !Costs::inseparable(cost))
          all.push_back({other, cost});
      }
      const auto kept = std::min(all.size(), std::size_t{kNearest});
      std::ranges::partial_sort(all, all.begin() + static_cast<std::ptrdiff_t>(kept),
                                [](const Near& a, const Near& b) {
                                  return std::pair(a.cost, a.node) < std::pair(b.cost, b.node);
                                });
      near_[static_cast<std::size_t>(node)].assign(all.begin(),
                                                   all.begin() + static_cast<std::ptrdiff_t>(kept));
    }
  }

  /// Improves around all listed nodes. Returns what was gained.
  Sum work_off() {
    Sum gained = 0;
    while (!work_.empty()) {
      const int node = work_.take();
      for (Sum gain = improve(node); gain > 0; gain = improve(node)) gained += gain;
    }
    return gained;
  }

  /// Applies a change that removes an edge of `node` and pays; returns what it gains, 0 without one.
  Sum improve(int node) {
    for (const bool ahead : {true, false}) {
      const int other = ahead ? ring_.next(node) : ring_.previous(node);
      const WholeCost cost = cost_(node, other);
      if (Costs::inseparable(cost)) continue;
      change_.nodes[0] = node;
      change_.nodes[1] = other;
      const Sum gain = deepen(cost);
      if (gain > 0) return gain;
    }
    return 0;
  }

  /// Depth-first, from the one removed edge in change_. `saved`: its cost.
  Sum deepen(Sum saved) {
    struct Level {
      Sum saved;      // by the edges removed so far, less those added
      int candidate;  // the next one to try: twice its place in the list, plus the side
    };
    std::array<Level, kDeepest> levels = {};
    int depth = 1;
    levels[1] = {saved, 0};
    while (depth > 0) {
      Level& level = levels[static_cast<std::size_t>(depth)];
      const int from = change_.nodes[static_cast<std::size_t>(2 * depth - 1)];
      const auto& near = near_[static_cast<std::size_t>(from)];
      const int candidate = level.candidate++;
      const auto rank = static_cast<std::size_t>(candidate / 2);
      if (rank >= near.size() || candidate / 2 >= kBreadth[static_cast<std::size_t>(depth)] ||
          near[rank].cost >= level.saved) {
        --depth;
        continue;
      }
      const int to = near[rank].node;
      const int beyond = (candidate & 1) == 0 ? ring_.next(to) : ring_.previous(to);
      if (beyond == from || !is_new(from, to, beyond, depth)) continue;
      const WholeCost removed = cost_(to, beyond);
      if (Costs::inseparable(removed)) continue;
      const Sum now_saved = level.saved - near[rank].cost + removed;
      change_.nodes[static_cast<std::size_t>(2 * depth)] = to;
      change_.nodes[static_cast<std::size_t>(2 * depth + 1)] = beyond;
      const Sum gain = now_saved - cost_(beyond, change_.nodes[0]);
      if (gain > 0 && apply(depth + 1)) return gain;
      if (depth + 1 < kDeepest) {
        ++depth;
        levels[static_cast<std::size_t>(depth)] = {now_saved, 0};
      }
    }
    return 0;
  }

  /// May the edge from-to be added, and to-beyond be removed?
  bool is_new(int from, int to, int beyond, int depth) const {
    if (ring_.next(from) == to || ring_.previous(from) == to) return false;
    for (int i = 0; i < 2 * depth; i += 2) {
      const int a = change_.nodes[static_cast<std::size_t>(i)];
      const int b = change_.nodes[static_cast<std::size_t>(i + 1)];
      if ((a == to && b == beyond) || (a == beyond && b == to)) return false;
    }
    return true;
  }

  bool apply(int edges) {
    change_.edges = edges;
    Pieces pieces;
    const int count = pieces_after(ring_, change_, pieces);
    if (count == 0 || !arrange(pieces, count)) return false;
    for (int i = 0; i < 2 * edges; ++i) work_.add(change_.nodes[static_cast<std::size_t>(i)]);
    return true;
  }

  /// Arranges the ring anew if what must come before something still does.
  bool arrange(const Pieces& pieces, int count) {
    const std::size_t before = ring_.log_size();
    ring_.arrange(pieces, count);
    if (problem_.before.empty() || reads(true) || reads(false)) return true;
    ring_.undo(before);
    return false;
  }

  /// Is the ring, read so from the first place, an order that obeys the problem?
  bool reads(bool forward) const {
    const int size = ring_.size();
    const int first = problem_.first * Costs::kNodesOfPlace;
    const auto beside = [&](bool ahead) {
      return ahead ? ring_.next(first) : ring_.previous(first);
    };
    if constexpr (Costs::kNodesOfPlace == 2) {
      if (beside(forward) != first + 1) return false;
    } else {
      if (problem_.start != OrderProblem::kNone && beside(forward) != problem_.start) return false;
      if (problem_.end != OrderProblem::kNone && beside(!forward) != problem_.end) return false;
    }
    const int begin = ring_.position(first);
    const auto rank = [&](int stop) {
      const int steps = ring_.position(stop * Costs::kNodesOfPlace) - begin;
      return ring_.wrapped((forward ? steps : -steps) + size);
    };
    return std::ranges::all_of(problem_.before, [&](const StopPair& pair) {
      return rank(pair.first) < rank(pair.second);
    });
  }

  /// Reverses the order of three short pieces in a row. Returns what it costs.
  Sum disturb() {
    const int size = ring_.size();
    const int longest = std::clamp((size - 1) / 4, 1, kLongestPiece);
    std::array<int, 4> cuts = {};  // edges begin there
    int at = static_cast<int>(random_.below(static_cast<std::uint64_t>(size)));
    int used = 0;
    for (int& cut : cuts) {
      for (; used < size && Costs::inseparable(edge_at(at)); ++used) at = ring_.wrapped(at + 1);
      cut = at;
      const int step = 1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(longest)));
      at = ring_.wrapped(at + step);
      used += &cut == &cuts.back() ? 0 : step;
    }
    if (used >= size) return kNotDisturbed;
    const auto behind = [&](int cut) { return ring_.wrapped(cut + 1); };
    const Pieces pieces = {
        Piece{behind(cuts[3]), cuts[0], false}, Piece{behind(cuts[2]), cuts[3], false},
        Piece{behind(cuts[1]), cuts[2], false}, Piece{behind(cuts[0]), cuts[1], false}};
    std::array<int, 8> ends = {};
    Sum paid = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      ends[2 * i] = ring_.node(cuts[i]);
      ends[2 * i + 1] = ring_.node(behind(cuts[i]));
      paid -= edge_at(cuts[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Piece& next = pieces[(i + 1) % 4];
      paid += cost_(ring_.node(pieces[i].last), ring_.node(next.first));
    }
    if (!arrange(pieces, 4)) return kNotDisturbed;
    for (const int node : ends) work_.add(node);
    return paid;
  }

  /// The cost of the edge that begins at a position.
  WholeCost edge_at(int at) const {
    return cost_(ring_.node(at), ring_.node(ring_.wrapped(at + 1)));
  }

  const OrderProblem& problem_;
  Costs cost_;
  Ring ring_;
  std::vector<std::vector<Near>> near_;
  WorkList work_;
  Random random_;
  Change change_;
};

}  // namespace

std::unique_ptr<OrderSearch> make_order_search(const OrderProblem& problem,
                                               const std::vector<int>& order, std::uint64_t seed) {
  if (problem.symmetric) return std::make_unique<Search<CostsBothWays>>(problem, order, seed);
  return std::make_unique<Search<CostsOneWay>>(problem, order, seed);
}

}  // namespace wend
