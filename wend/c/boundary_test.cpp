#include "wend/c/boundary.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "wend/version.hpp"

namespace wend::c {
namespace {

TEST(CBoundary, SaysItsVersions) {
  EXPECT_EQ(wend_abi_version(), WEND_ABI_VERSION);
  EXPECT_STREQ(wend_version(), WEND_VERSION);
}

TEST(CBoundary, KeepsTheNumbersOfStatusesAndTheirNames) {
  std::set<std::string> names{wend_status_name(WEND_OK), wend_status_name(WEND_INVALID_ARGUMENT),
                              wend_status_name(WEND_INTERNAL_ERROR)};
  EXPECT_EQ(status_of(Status::found), WEND_OK);
  EXPECT_STREQ(wend_status_name(WEND_OK), "ok");
  for (wend_status number = WEND_START_OUTSIDE; number <= WEND_INDEX_MISMATCH; ++number) {
    const auto status = status_from_string(wend_status_name(number));
    ASSERT_TRUE(status) << number;
    EXPECT_EQ(status_of(*status), number);
    names.insert(wend_status_name(number));
  }
  EXPECT_EQ(names.size(), 20U) << "two statuses have one name";
  for (const wend_status number : {-1, WEND_INDEX_MISMATCH + 1, 99, 102}) {
    EXPECT_STREQ(wend_status_name(number), "unknown");
  }
}

TEST(CBoundary, ReportsAFailureAndItsSearch) {
  wend_error error;
  const wend_status status = guarded(&error, []() -> Expected<void, Failure> {
    return failed(PlanFailure{{Status::unreachable, "no way", "goal"}, {7, 9, 2}});
  });
  EXPECT_EQ(status, WEND_UNREACHABLE);
  EXPECT_EQ(error.status, WEND_UNREACHABLE);
  EXPECT_STREQ(error.message, "no way");
  EXPECT_EQ(error.truncated, 0);
  EXPECT_EQ(error.expanded, 7U);
  EXPECT_EQ(error.generated, 9U);
}

TEST(CBoundary, ClearsTheErrorOfAnEarlierCall) {
  wend_error error;
  report(WEND_UNREACHABLE, "no way", {1, 2, 3}, &error);
  EXPECT_EQ(guarded(&error, []() -> Expected<void, Failure> { return {}; }), WEND_OK);
  EXPECT_EQ(error.status, WEND_OK);
  EXPECT_STREQ(error.message, "");
  EXPECT_EQ(error.expanded, 0U);
}

TEST(CBoundary, StopsExceptions) {
  wend_error error;
  const auto throwing = [&](auto thrown) {
    return guarded(&error, [&]() -> Expected<void, Failure> { throw thrown; });
  };
  EXPECT_EQ(throwing(std::bad_alloc()), WEND_MEMORY_LIMIT);
  EXPECT_STREQ(error.message, "there is not enough memory");
  EXPECT_EQ(throwing(std::runtime_error("broken")), WEND_INTERNAL_ERROR);
  EXPECT_STREQ(error.message, "broken");
  EXPECT_EQ(throwing(7), WEND_INTERNAL_ERROR);
  EXPECT_STREQ(error.message, "an exception of unknown type");
}

TEST(CBoundary, CutsALongMessageBetweenCharacters) {
  wend_error error;
  const std::string fits(WEND_MESSAGE_SIZE - 1, 'a');
  report(WEND_INVALID_FILE, fits.c_str(), {}, &error);
  EXPECT_EQ(error.message, fits);
  EXPECT_EQ(error.truncated, 0);
  report(WEND_INVALID_FILE, (fits + "b").c_str(), {}, &error);
  EXPECT_EQ(error.message, fits);
  EXPECT_EQ(error.truncated, 1);
  const std::string wide = fits.substr(2) + "\u20AC";  // three bytes, of which one does not fit
  report(WEND_INVALID_FILE, wide.c_str(), {}, &error);
  EXPECT_EQ(error.message, fits.substr(2));
  EXPECT_EQ(error.truncated, 1);
}

TEST(CBoundary, MakesALineOfUtf8OfAnyMessage) {
  wend_error error;
  const auto said = [&](std::string message) {
    guarded(&error, [&]() -> Expected<void, Failure> { return refused(std::move(message)); });
    return std::string(error.message);
  };
  EXPECT_EQ(said("no planner '\u20AC'"), "no planner '\u20AC'");
  EXPECT_EQ(said("no planner 'a\x01\xff'"), "no planner 'a\\x01\\xFF'");
  EXPECT_EQ(said("two\nlines"), "two lines");
}

TEST(CBoundary, InitialisesOnlyStructuresOfItsSize) {
  wend_request request;
  EXPECT_EQ(wend_request_init(nullptr, sizeof request), WEND_INVALID_ARGUMENT);
  std::array<unsigned char, sizeof request> before{};
  std::memset(&request, 0x55, sizeof request);
  std::memcpy(before.data(), &request, sizeof request);
  EXPECT_EQ(wend_request_init(&request, sizeof request - 8), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(wend_request_init(&request, sizeof request + 8), WEND_INVALID_ARGUMENT);
  EXPECT_EQ(std::memcmp(before.data(), &request, sizeof request), 0) << "it was written to";
  EXPECT_EQ(wend_request_init(&request, sizeof request), WEND_OK);
  EXPECT_EQ(request.struct_size, sizeof request);
  EXPECT_STREQ(request.planner, "astar");
}

}  // namespace
}  // namespace wend::c
