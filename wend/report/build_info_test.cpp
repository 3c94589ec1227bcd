#include "wend/report/build_info.hpp"

#include <gmock/gmock.h>

namespace wend {
namespace {

TEST(BuildInfo, HasAVersionAndACommit) {
  EXPECT_THAT(std::string(wend_version()), testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(std::string(wend_commit()), testing::MatchesRegex("unknown|[0-9a-f]{7,40}(-dirty)?"));
}

}  // namespace
}  // namespace wend
