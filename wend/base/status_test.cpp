#include "wend/base/status.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace wend {
namespace {

// The names are an interface: exit codes, JSON and ROS results carry them.
const std::vector<std::string> kNames{
    "found",         "start_outside",   "goal_outside",      "start_blocked",  "goal_blocked",
    "unreachable",   "step_limit",      "expansion_limit",   "time_limit",     "memory_limit",
    "cancelled",     "unsupported_map", "unsupported_query", "invalid_option", "index_missing",
    "index_mismatch"};

TEST(Status, EveryNameReadsBackAsTheSameStatus) {
  for (const std::string& name : kNames) {
    SCOPED_TRACE(name);
    const auto status = status_from_string(name);
    ASSERT_TRUE(status.has_value());
    EXPECT_EQ(to_string(*status), name);
  }
}

TEST(Status, NoTwoNamesMeanTheSame) {
  std::set<Status> statuses;
  for (const std::string& name : kNames) statuses.insert(status_from_string(name).value());
  EXPECT_EQ(statuses.size(), kNames.size());
  EXPECT_EQ(*statuses.begin(), Status::found);
  EXPECT_EQ(*statuses.rbegin(), Status::index_mismatch);
}

TEST(Status, DescriptionsAreSentencesOfTheirOwn) {
  std::set<std::string> sentences;
  for (const std::string& name : kNames) {
    SCOPED_TRACE(name);
    const std::string sentence(describe(status_from_string(name).value()));
    EXPECT_NE(sentence.find(' '), std::string::npos);
    EXPECT_EQ(sentence.find('_'), std::string::npos);
    EXPECT_TRUE(sentences.insert(sentence).second);
  }
}

TEST(Status, OtherNamesAreNone) {
  for (const char* const name : {"", "Found", "found ", " found", "foun", "start outside", "ok"}) {
    EXPECT_FALSE(status_from_string(name).has_value()) << name;
  }
}

}  // namespace
}  // namespace wend
