// SPDX-License-Identifier: Apache-2.0
// Every file that a fuzzer was given or has found, once more: what crashed once never does again.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/base/file.hpp"

#include "fuzz/fuzz.hpp"

namespace jounce {
namespace {

using FuzzTarget = void (*)(fuzz::Input);

struct Named {
  const char* name;
  FuzzTarget target;
};

class ReplayFuzz : public testing::TestWithParam<Named> {};

/// tests/fuzz/corpus/NAME/*, tests/fuzz/crashes/NAME-* and the examples.
std::vector<std::filesystem::path> files_of(const std::string& name) {
  const std::filesystem::path source = JOUNCE_SOURCE_DIR;
  const std::filesystem::path root = source / "tests/fuzz";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source / "examples"))
    if (entry.is_regular_file() && entry.file_size() < 200'000) files.push_back(entry.path());
  for (const auto& entry : std::filesystem::directory_iterator(root / "corpus" / name))
    files.push_back(entry.path());
  for (const auto& entry : std::filesystem::directory_iterator(root / "crashes"))
    if (entry.path().filename().string().starts_with(name + "-")) files.push_back(entry.path());
  return files;
}

TEST_P(ReplayFuzz, FindsNothing) {
  const auto files = files_of(GetParam().name);
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    const std::string bytes = read_file(file.string(), Archive::returned);
    const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    GetParam().target({data, bytes.size()});
    GetParam().target({data, bytes.size() / 2});  // cut short
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzz, ReplayFuzz,
                         testing::Values(Named{"wire", fuzz::wire}, Named{"session", fuzz::session},
                                         Named{"rows", fuzz::rows}, Named{"key", fuzz::key},
                                         Named{"executor", fuzz::executor}, Named{"log", fuzz::log},
                                         Named{"table", fuzz::table}, Named{"points", fuzz::points},
                                         Named{"spec", fuzz::spec}, Named{"gcode", fuzz::gcode},
                                         Named{"recording", fuzz::recording},
                                         Named{"text", fuzz::text}, Named{"page", fuzz::page}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace jounce
