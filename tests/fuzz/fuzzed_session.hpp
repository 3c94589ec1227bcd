#pragma once

// A session of the C interface with any sequence of calls: edits, other maps, masks, occupancy grids, robots, plans,
// plans again, fields. What a session keeps from call to call never changes an answer: it is that of a new session on
// the same map, for the same robot. And a path is free on the present map.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzzed_bytes.hpp"
#include "fuzzed_c_interface.hpp"
#include "session_model.hpp"

namespace wend::test {

/// A planner, and what holds for its answers.
struct FuzzedPlanner {
  const char* spec;
  bool headings = false;  // its paths are poses joined by arcs
  bool index = false;     // it answers index_mismatch after an edit
};

inline constexpr std::array kFuzzedPlanners{
    FuzzedPlanner{"astar"},
    FuzzedPlanner{"astar:connectivity=4"},
    FuzzedPlanner{"astar:weight=2"},
    FuzzedPlanner{"dijkstra"},
    FuzzedPlanner{"alt:landmarks=2"},
    FuzzedPlanner{"ara_star"},
    FuzzedPlanner{"jps"},
    FuzzedPlanner{"any_angle"},
    FuzzedPlanner{"theta_star"},
    FuzzedPlanner{"lazy_theta_star"},
    FuzzedPlanner{"greedy"},
    FuzzedPlanner{"bfs"},
    FuzzedPlanner{"dfs"},
    FuzzedPlanner{"random_walk:max_steps=500"},
    FuzzedPlanner{"replanner"},
    FuzzedPlanner{"d_star_lite"},
    FuzzedPlanner{"jps:corner_rule=both"},
    FuzzedPlanner{"hub_labels", false, true},
    FuzzedPlanner{"euclidean_labels", false, true},
    FuzzedPlanner{"lattice", true},
    FuzzedPlanner{"car", true},
    FuzzedPlanner{"hybrid_astar", true},
};

/// How a call for a plan ended.
struct FuzzedAnswer {
  wend_status status = WEND_OK;
  Owned<wend_plan> plan = {};
};

class FuzzedSession {
 public:
  explicit FuzzedSession(FuzzedBytes& bytes) : bytes_(bytes) {
    told_.policies.unknown = bytes.byte() % 3;
    told_.policies.outside = bytes.byte() % 3;
    told_.map = next_map();
    session_ = told_.made();
  }

  /// The next call; what is wrong with how it ended.
  std::string next() {
    switch (bytes_.byte() % 12) {
      case 0:
        return edit();
      case 1:
        return edit();
      case 2:
        return edit_terrain();
      case 3:
        return set_map();
      case 4:
        return set_robot();
      case 5:
        return ask_places();
      case 6:
        return field();
      case 7:
        return stopped_plan();
      case 8:
        return plan();
      case 9:
        return plan();
      default:
        return replan();
    }
  }

 private:
  /// Mostly free cells; in every fourth map some cost more.
  ModelMap next_map() {
    ModelMap map;
    map.width = 1 + bytes_.byte() % kLongest;
    map.height = 1 + bytes_.byte() % kLongest;
    map.resolution = 0.5 * (1 << bytes_.byte() % 3);
    const bool terrain = bytes_.byte() % 4 == 0;
    for (int i = 0; i < map.width * map.height; ++i) {
      const std::uint8_t cell = bytes_.byte();
      map.states.push_back(cell < 190 ? 0 : cell < 240 ? 1 : 2);
      map.terrain.push_back(terrain ? 1 + cell % 4 : 1);
    }
    return map;
  }

  ModelBox next_box() {
    const ModelMap& map = told_.map;
    ModelBox box{bytes_.byte() % map.width, bytes_.byte() % map.height, 1 + bytes_.byte() % 3,
                 1 + bytes_.byte() % 3};
    if (bytes_.byte() < 16) box.x -= 2;
    return box;
  }

  wend_pose next_pose() {
    const ModelMap& map = told_.map;
    const wend_pose origin = map.origin();
    const auto along = [&](int cells, double from) {
      const int halves = bytes_.byte() % (2 * cells);
      return from + 0.5 * map.resolution * (halves % 4 == 0 ? halves : halves | 1);
    };
    wend_pose pose{along(map.width, origin.x), along(map.height, origin.y),
                   0.25 * kPi * (bytes_.byte() % 8)};
    if (bytes_.byte() < 8) pose.x -= map.width * map.resolution;
    return pose;
  }

  /// Whether a call that changes the session ended as it should have.
  std::string check_change(wend_status status, const wend_error& error, bool fits) {
    const std::string wrong = check_end(status, status == WEND_OK ? this : nullptr, error);
    if (!wrong.empty()) return wrong;
    return (status == WEND_OK) == fits ? "" : "a change fits, or it does not";
  }

  std::string edit() {
    const ModelBox box = next_box();
    bool fits = told_.map.has(box);
    std::vector<std::uint8_t> states(box.size());
    for (std::uint8_t& state : states) {
      const std::uint8_t cell = bytes_.byte();
      state = cell < 110 ? 0 : cell < 220 ? 1 : cell < 250 ? 2 : 3;
      fits = fits && state < 3;
    }
    wend_error error;
    const wend_status status = wend_session_edit(session_.get(), box.x, box.y, box.width,
                                                 box.height, states.data(), states.size(), &error);
    if (status == WEND_OK && fits) {
      edited_ = true;
      told_.map.each_of(box,
                        [&](std::size_t to, std::size_t i) { told_.map.states[to] = states[i]; });
    }
    return check_change(status, error, fits);
  }

  std::string edit_terrain() {
    const ModelBox box = next_box();
    bool fits = told_.map.has(box);
    std::vector<double> terrain(box.size());
    for (double& each : terrain) {
      const std::uint8_t cost = bytes_.byte();
      each = cost < 250 ? 1 + cost % 8 * 0.25 : std::nan("");
      fits = fits && cost < 250;
    }
    wend_error error;
    const wend_status status =
        wend_session_edit_terrain(session_.get(), box.x, box.y, box.width, box.height,
                                  terrain.data(), terrain.size(), &error);
    if (status == WEND_OK && fits) {
      edited_ = true;
      told_.map.each_of(box,
                        [&](std::size_t to, std::size_t i) { told_.map.terrain[to] = terrain[i]; });
    }
    return check_change(status, error, fits);
  }

  /// The map of an occupancy grid or of a costmap, and the same by the table of wend/map/occupancy.hpp.
  Owned<wend_map> map_of_values(ModelMap& map, std::string& wrong) {
    const bool costmap = bytes_.byte() % 2 == 1;
    const double factor = bytes_.byte() % 5;
    const int from = 1 + bytes_.byte() % 100;
    std::vector<std::uint8_t> values(map.states.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const int value = values[i] = bytes_.byte();
      const int occupied = costmap ? 253 : from;
      const int known = costmap ? 255 : 101;
      map.states[i] = value < occupied ? 0 : value < known ? 1 : 2;
      map.terrain[i] = value < occupied ? 1 + factor * value / (costmap ? 252 : 100) : 1;
    }
    const wend_pose origin = map.origin();
    return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
      if (costmap) {
        return wend_map_from_costmap(values.data(), values.size(), map.width, map.height,
                                     map.resolution, &origin, factor, out, error);
      }
      return wend_map_from_occupancy(reinterpret_cast<const std::int8_t*>(values.data()),
                                     values.size(), map.width, map.height, map.resolution, &origin,
                                     from, factor, out, error);
    });
  }

  /// Under a mask of the same resolution, which may lie beside the map.
  Owned<wend_map> masked_map(ModelMap& map, std::string& wrong) {
    ModelMap mask = next_map();
    mask.resolution = map.resolution;
    mask.column = bytes_.byte() % 16 - 8;
    mask.row = bytes_.byte() % 16 - 8;
    const auto below = map.made();
    const auto above = mask.made();
    const bool touches = map.take_mask(mask);
    auto made = fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
      return wend_map_masked(below.get(), above.get(), out, error);
    });
    if (touches != (made != nullptr) && wrong.empty()) wrong = "a mask touches, or it does not";
    return made;
  }

  /// With other costs, from an array or from a function.
  Owned<wend_map> map_with_costs(ModelMap& map, std::string& wrong) {
    const auto below = map.made();
    for (double& each : map.terrain) each = 1 + 0.5 * (bytes_.byte() % 4);
    if (bytes_.byte() % 2 == 0) {
      return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
        return wend_map_with_terrain(below.get(), map.terrain.data(), map.terrain.size(), out,
                                     error);
      });
    }
    const wend_cost_function cost_of = [](std::int32_t x, std::int32_t y, void* context) {
      const ModelMap& its_map = *static_cast<const ModelMap*>(context);
      return its_map.terrain[its_map.at(x, y)];
    };
    return fuzzed_object<wend_map>(wrong, [&](wend_map** out, wend_error* error) {
      return wend_map_with_costs(below.get(), cost_of, &map, out, error);
    });
  }

  std::string set_map() {
    const std::uint8_t kind = bytes_.byte();
    ModelMap map = kind % 2 == 0 ? told_.map : next_map();
    map.column = kind / 16;
    std::string wrong;
    const auto made = kind % 8 < 2   ? map_of_values(map, wrong)
                      : kind % 8 < 4 ? masked_map(map, wrong)
                      : kind % 8 < 6 ? map_with_costs(map, wrong)
                                     : map.made();
    if (!made) return wrong;
    wend_error error;
    const wend_status status = wend_session_set_map(session_.get(), made.get(), &error);
    told_.map = std::move(map);
    edited_ = false;
    return check_change(status, error, true);
  }

  std::string set_robot() {
    constexpr std::array<const char*, 6> kShapes{"disc:0",   "disc:0.3",     "disc:0.5",
                                                 "disc:1.1", "rect:0.8x0.5", "rect:1.5x0.5,0.4"};
    const std::uint8_t kind = bytes_.byte();
    told_.robot = {kShapes[kind % kShapes.size()], kind < 128 ? 0.0 : 2.0};
    edited_ = true;  // an index is for a robot
    const auto robot = told_.robot.made();
    wend_error error;
    return check_change(wend_session_set_robot(session_.get(), robot.get(), &error), error, true);
  }

  std::string ask_places() {
    const wend_pose pose = next_pose();
    const auto fresh = told_.made();
    const auto ask = [&](wend_session* session, wend_pose& nearest, std::int32_t& fits) {
      wend_error error;
      wend_session_fits(session, &pose, &fits, &error);
      return wend_session_nearest(session, &pose, &nearest, &error);
    };
    wend_pose here{};
    wend_pose there{};
    std::int32_t fits = -1;
    std::int32_t fits_there = -1;
    if (ask(session_.get(), here, fits) != ask(fresh.get(), there, fits_there)) {
      return "a place is near, or it is not";
    }
    const bool same = here.x == there.x && here.y == there.y && fits == fits_there;
    return same ? check_questions(session_.get(), pose) : "another place is the nearest";
  }

  /// One or two goals. At most two queries for robots with headings: they take long.
  wend_request next_request(const FuzzedPlanner*& planner) {
    planner = &kFuzzedPlanners[bytes_.byte() % kFuzzedPlanners.size()];
    if (planner->headings && headed_++ >= 2) planner = &kFuzzedPlanners.front();
    wend_request request;
    wend_request_init(&request, sizeof request);
    request.start = next_pose();
    goals_ = {next_pose(), next_pose()};
    const std::uint8_t how = bytes_.byte();
    request.goals = goals_.data();
    request.goal_count = how % 4 == 0 ? 2 : 1;
    if (how % 8 < 4) goals_.front().heading = kAnyHeading;
    if (how / 8 % 4 == 0) request.tolerance = told_.map.resolution;
    request.planner = planner->spec;
    request.straighten = how / 32 % 2;
    request.explain = how / 64 % 2;
    return request;
  }

  static FuzzedAnswer answer_of(wend_session* session, const wend_request& request, bool again,
                                std::string& wrong) {
    FuzzedAnswer answer;
    answer.plan = fuzzed_object<wend_plan>(wrong, [&](wend_plan** out, wend_error* error) {
      answer.status = again ? wend_session_replan(session, &request, out, error)
                            : wend_session_plan(session, &request, out, error);
      return answer.status;
    });
    if (wrong.empty()) wrong = check_plan(answer.plan.get());
    return answer;
  }

  std::string check_free(const FuzzedAnswer& answer, const FuzzedPlanner& planner) const {
    if (!answer.plan || told_.is_free(answer.plan.get(), planner.headings)) return {};
    return std::string(planner.spec) + ": a path that is not free on the present map";
  }

  static bool same_cost(const wend_plan* one, const wend_plan* other) {
    const double cost = wend_plan_cost(one);
    return std::abs(cost - wend_plan_cost(other)) <= kSame * (1 + cost);
  }

  std::string plan() {
    const FuzzedPlanner* planner = nullptr;
    wend_request request = next_request(planner);
    const std::uint8_t eased = bytes_.byte();
    request.closest = eased % 8 == 1;
    request.nearest = eased % 8 == 2;
    std::string wrong;
    const FuzzedAnswer answer = answer_of(session_.get(), request, false, wrong);
    if (!wrong.empty()) return wrong;
    if (planner->index && edited_ && answer.status == WEND_INDEX_MISMATCH) return {};
    const FuzzedAnswer fresh = answer_of(told_.made().get(), request, false, wrong);
    if (!wrong.empty()) return wrong;
    const std::string name = planner->spec;
    if (answer.status != fresh.status) {
      return name + ": " + wend_status_name(answer.status) + " and not " +
             wend_status_name(fresh.status);
    }
    if (answer.plan && !same_cost(answer.plan.get(), fresh.plan.get())) {
      return name + ": another cost than in a new session";
    }
    return check_free(answer, *planner);
  }

  /// For the robot of a drive: often the last request, from another place.
  std::string replan() {
    const FuzzedPlanner* planner = driving_;
    wend_request request = driven_;
    if (planner == nullptr || bytes_.byte() < 80) {
      request = next_request(planner);
      driven_goals_ = goals_;
    } else if (last_start_ && bytes_.byte() < 200) {
      request.start = *last_start_;
    }
    request.goals = driven_goals_.data();
    request.keep = 0.25 * (bytes_.byte() % 3);
    driving_ = planner;
    driven_ = request;
    std::string wrong;
    const FuzzedAnswer answer = answer_of(session_.get(), request, true, wrong);
    if (!wrong.empty()) return wrong;
    last_start_ = next_start(answer);
    if (planner->index && edited_ && answer.status == WEND_INDEX_MISMATCH) return {};
    const FuzzedAnswer fresh = answer_of(told_.made().get(), request, false, wrong);
    if (wrong.empty()) wrong = compare_again(answer, fresh, request);
    if (!wrong.empty()) return std::string(planner->spec) + ": " + wrong;
    return check_free(answer, *planner);
  }

  static std::string compare_again(const FuzzedAnswer& answer, const FuzzedAnswer& fresh,
                                   const wend_request& request) {
    const bool kept = wend_plan_kept(answer.plan.get()) == 1;
    if (!kept && answer.status != fresh.status) {
      return std::string("planned again: ") + wend_status_name(answer.status) + " and not " +
             wend_status_name(fresh.status);
    }
    if (!answer.plan || !fresh.plan) return {};
    const double cost = wend_plan_cost(answer.plan.get());
    const double its_cost = wend_plan_cost(fresh.plan.get());
    if (!kept && !same_cost(answer.plan.get(), fresh.plan.get()))
      return "planned again: another cost";
    if (its_cost < (1 - request.keep) * cost - kSame * (1 + cost)) return "a path is kept too long";
    return {};
  }

  /// Where a robot is that has begun to follow the answer.
  std::optional<wend_pose> next_start(const FuzzedAnswer& answer) {
    if (!answer.plan) return std::nullopt;
    const std::size_t count = wend_plan_pose_count(answer.plan.get());
    return wend_plan_poses(answer.plan.get())[std::min<std::size_t>(bytes_.byte() % 4, count - 1)];
  }

  std::string field() {
    const FuzzedPlanner* planner = nullptr;
    const wend_request request = next_request(planner);
    std::string wrong;
    const auto made = [&](wend_session* session) {
      return fuzzed_object<wend_field>(wrong, [&](wend_field** out, wend_error* error) {
        return wend_session_field(session, &request, out, error);
      });
    };
    const auto field = made(session_.get());
    const auto fresh = made(told_.made().get());
    if (!wrong.empty()) return wrong;
    if ((field != nullptr) != (fresh != nullptr)) return "a field, or none";
    if (!field) return {};
    for (std::size_t i = 0; i < told_.map.states.size(); ++i) {
      if (wend_field_costs(field.get())[i] != wend_field_costs(fresh.get())[i]) {
        return "a field with another cost than in a new session";
      }
    }
    return check_field(field.get(), request.start);
  }

  /// A call that is ended, by a flag or a limit, leaves the session as it was: the calls after it show that.
  std::string stopped_plan() {
    const FuzzedPlanner* planner = nullptr;
    wend_request request = next_request(planner);
    const std::uint8_t how = bytes_.byte();
    wend_cancel* cancel = nullptr;
    wend_error error;
    if (wend_cancel_create(&cancel, &error) != WEND_OK) return "no flag";
    wend_cancel_set(cancel, how % 2);
    request.cancel = cancel;
    if (how % 4 < 2) request.expansions = how / 4 % 32;
    if (how % 8 == 3) request.seconds = 0;
    std::string wrong;
    const FuzzedAnswer answer = answer_of(session_.get(), request, how >= 128, wrong);
    wend_cancel_free(cancel);
    driving_ = nullptr;
    return wrong.empty() ? check_free(answer, *planner) : wrong;
  }

  static constexpr int kLongest = 12;
  static constexpr double kSame = 2e-6;

  FuzzedBytes& bytes_;
  SessionModel told_;
  Owned<wend_session> session_;
  bool edited_ = false;  // since the map was set: an index need not match
  int headed_ = 0;
  std::array<wend_pose, 2> goals_{};

  // What wend_session_replan() was last asked.
  const FuzzedPlanner* driving_ = nullptr;
  wend_request driven_{};
  std::array<wend_pose, 2> driven_goals_{};
  std::optional<wend_pose> last_start_;
};

inline std::string fuzz_session(std::string_view input) {
  FuzzedBytes bytes(input);
  FuzzedSession session(bytes);
  constexpr int kMostCalls = 24;
  for (int call = 0; call < kMostCalls && !bytes.empty(); ++call) {
    std::string wrong = session.next();
    if (!wrong.empty()) return wrong;
  }
  return {};
}

}  // namespace wend::test
