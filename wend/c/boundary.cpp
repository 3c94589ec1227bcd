#include "wend/c/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

#include "wend/io/text.hpp"
#include "wend/version.hpp"

namespace wend::c {
namespace {

bool continues_a_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80; }

}  // namespace

wend_status status_of(Status status) {
  switch (status) {
    case Status::found:
      return WEND_OK;
    case Status::start_outside:
      return WEND_START_OUTSIDE;
    case Status::goal_outside:
      return WEND_GOAL_OUTSIDE;
    case Status::start_blocked:
      return WEND_START_BLOCKED;
    case Status::goal_blocked:
      return WEND_GOAL_BLOCKED;
    case Status::unreachable:
      return WEND_UNREACHABLE;
    case Status::step_limit:
      return WEND_STEP_LIMIT;
    case Status::expansion_limit:
      return WEND_EXPANSION_LIMIT;
    case Status::time_limit:
      return WEND_TIME_LIMIT;
    case Status::memory_limit:
      return WEND_MEMORY_LIMIT;
    case Status::cancelled:
      return WEND_CANCELLED;
    case Status::unsupported_map:
      return WEND_UNSUPPORTED_MAP;
    case Status::unsupported_query:
      return WEND_UNSUPPORTED_QUERY;
    case Status::invalid_option:
      return WEND_INVALID_OPTION;
    case Status::invalid_map:
      return WEND_INVALID_MAP;
    case Status::invalid_file:
      return WEND_INVALID_FILE;
    case Status::index_missing:
      return WEND_INDEX_MISSING;
    case Status::index_mismatch:
      return WEND_INDEX_MISMATCH;
  }
  return WEND_INTERNAL_ERROR;
}

wend_status report(wend_status status, const char* message, const SearchMetrics& metrics,
                   wend_error* error) noexcept {
  if (error == nullptr) return status;
  const std::size_t length = std::strlen(message);
  std::size_t kept = std::min<std::size_t>(length, WEND_MESSAGE_SIZE - 1);
  if (kept < length) {
    while (kept > 0 && continues_a_character(message[kept])) --kept;
  }
  error->status = status;
  error->truncated = kept < length ? 1 : 0;
  error->expanded = metrics.expanded;
  error->generated = metrics.generated;
  std::memcpy(error->message, message, kept);
  error->message[kept] = '\0';
  return status;
}

wend_status report(const Failure& failure, wend_error* error) {
  constexpr std::size_t kLongestEscape = 4;  // \xNN
  const std::string line = text_line(failure.message, kLongestEscape * failure.message.size());
  return report(failure.status, line.c_str(), failure.metrics, error);
}

wend_status report_exception(wend_error* error) noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return report(WEND_MEMORY_LIMIT, "there is not enough memory", {}, error);
  } catch (const std::exception& thrown) {
    return report(WEND_INTERNAL_ERROR, thrown.what(), {}, error);
  } catch (...) {
    return report(WEND_INTERNAL_ERROR, "an exception of unknown type", {}, error);
  }
}

bool is_finite(const wend_pose& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

}  // namespace wend::c

uint32_t wend_abi_version(void) { return WEND_ABI_VERSION; }

const char* wend_version(void) { return WEND_VERSION; }

const char* wend_status_name(wend_status status) {
  switch (status) {
    case WEND_OK:
      return "ok";
    case WEND_INVALID_ARGUMENT:
      return "invalid_argument";
    case WEND_INTERNAL_ERROR:
      return "internal_error";
    default:
      break;
  }
  // The numbers of the others are their places in Status; its names are literals.
  if (status < WEND_OK || status > WEND_INDEX_MISMATCH) return "unknown";
  return wend::to_string(static_cast<wend::Status>(status)).data();
}
