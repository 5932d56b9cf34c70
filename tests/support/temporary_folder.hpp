// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace jounce::test {

/// A test with an empty folder of its own, which is removed with the test.
class WithFolder : public ::testing::Test {
 protected:
  WithFolder() {
    std::string name = "/tmp/jounce-test-XXXXXX";
    if (mkdtemp(name.data()) == nullptr) std::abort();
    folder_ = name;
  }
  ~WithFolder() override { std::filesystem::remove_all(folder_); }
  WithFolder(const WithFolder&) = delete;
  WithFolder& operator=(const WithFolder&) = delete;

  [[nodiscard]] std::string folder() const { return folder_.string(); }
  [[nodiscard]] std::string in(const char* name) const { return (folder_ / name).string(); }

  /// The number of files and folders in it.
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  std::filesystem::path folder_;
};

}  // namespace jounce::test
