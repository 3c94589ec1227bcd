#include "wend/render/file_writer.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <system_error>

namespace wend {
namespace {

namespace fs = std::filesystem;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

Unexpected<RenderError> error(const fs::path& file, const std::error_code& code) {
  return Unexpected<RenderError>({file.string(), code.message()});
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// Mode "wx" refuses to open a file that exists.
std::error_code write_bytes(const fs::path& file, std::string_view bytes, const char* mode) {
  std::unique_ptr<std::FILE, FileCloser> stream(std::fopen(file.c_str(), mode));
  if (!stream) return last_error();
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size()) return last_error();
  if (std::fclose(stream.release()) != 0) return last_error();
  return {};
}

/// A name in the same folder that no other program uses.
fs::path temporary_name(const fs::path& file) {
  fs::path name = file;
  name += ".part" + std::to_string(std::random_device{}());
  return name;
}

}  // namespace

Expected<void, RenderError> write_picture(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const auto code = write_bytes(file, bytes, "wb")) return error(file, code);
    return {};
  }
  const fs::path temporary = temporary_name(file);
  std::error_code code = write_bytes(temporary, bytes, "wbx");
  if (!code) fs::rename(temporary, file, code);
  if (code) {
    fs::remove(temporary, ignored);
    return error(file, code);
  }
  return {};
}

}  // namespace wend
