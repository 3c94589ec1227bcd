// The inputs of the fuzzers, replayed: our own seeds, whatever once went wrong, and all malformed
// files of the shared data, for every loader.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <vector>

#include "tests/fuzz/loaders.hpp"
#include "tests/testing/build_paths.hpp"

namespace wend::test {

inline void PrintTo(const Loader& loader, std::ostream* out) { *out << loader.name; }

namespace {

namespace fs = std::filesystem;

const fs::path kFuzzFolder = source_folder() / "tests" / "fuzz";

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// All files of a folder that may not be there.
std::vector<fs::path> files_under(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzedLoader : public testing::TestWithParam<Loader> {
 protected:
  static void replay(const fs::path& file) {
    EXPECT_EQ(GetParam().fuzz(content_of(file)), "") << GetParam().name << " on " << file;
  }
};

TEST_P(FuzzedLoader, DoesNothingWrongOnTheSeedsOfEveryLoader) {
  EXPECT_FALSE(files_under(kFuzzFolder / "seeds" / GetParam().name).empty());
  for (const fs::path& file : files_under(kFuzzFolder / "seeds")) replay(file);
}

TEST_P(FuzzedLoader, DoesNothingWrongOnWhatOnceWentWrong) {
  for (const fs::path& file : files_under(kFuzzFolder / "regressions")) replay(file);
}

TEST_P(FuzzedLoader, DoesNothingWrongOnMalformedFiles) {
  const fs::path folder = data_folder() / "bad";
  if (!fs::exists(folder)) GTEST_SKIP() << "WEND_DATA names no folder with bad/";
  for (const fs::path& file : files_under(folder)) replay(file);
}

TEST_P(FuzzedLoader, HasItsFuzzer) {
  const std::string file = std::string(GetParam().name) + "_fuzzer.cpp";
  EXPECT_TRUE(fs::exists(kFuzzFolder / file)) << file;
}

INSTANTIATE_TEST_SUITE_P(, FuzzedLoader, testing::ValuesIn(fuzzed_loaders()),
                         [](const auto& loader) { return std::string(loader.param.name); });

}  // namespace
}  // namespace wend::test
