#pragma once

// A map of 5 x 4 cells and scenarios beside it, for the tests of `wend bench`.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/command_line/run_program.hpp"

namespace wend::test {

inline constexpr const char* kBenchMap =
    "type octile\nheight 4\nwidth 5\nmap\n.....\n.@@T.\n.G.S.\n.....\n";

/// Two queries whose lengths are right.
inline constexpr const char* kRight =
    "0\tok.map\t5\t4\t0\t0\t4\t0\t4\n1\tok.map\t5\t4\t0\t0\t4\t3\t6.41421356\n";

class BenchFolder {
 public:
  /// A scenario's file, beside ok.map.
  std::string scenario(const std::string& queries, const std::string& name = "ok.map.scen") const {
    folder_.write("ok.map", kBenchMap);
    return folder_.write(name, "version 1\n" + queries);
  }

  /// What `wend bench` writes with --format json.
  static nlohmann::json results(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"--format", "json"});
    return nlohmann::json::parse(wend(std::move(arguments)).out);
  }

  /// The rows of that.
  static nlohmann::json rows(std::vector<std::string> arguments) {
    return results(std::move(arguments)).at("rows");
  }

  TemporaryFolder folder_;
};

}  // namespace wend::test
