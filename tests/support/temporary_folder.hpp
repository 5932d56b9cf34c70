// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace jounce::test {

/// A new empty folder, which its destructor removes with all files in it. ctest runs each test as a process of its own,
/// several at once: a fixed name would be shared.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "jounce-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// A test with a folder of its own.
class WithFolder : public ::testing::Test {
 protected:
  [[nodiscard]] std::string folder() const { return folder_.string(); }
  [[nodiscard]] std::string in(const char* name) const { return (folder_ / name).string(); }

  /// The number of files and folders in it.
  [[nodiscard]] std::size_t files() const {
    const std::filesystem::directory_iterator all(folder_);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

 private:
  TemporaryFolder own_;

 protected:
  const std::filesystem::path& folder_ = own_.path();
};

}  // namespace jounce::test
