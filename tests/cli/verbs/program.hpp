// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "../../support/temporary_folder.hpp"

namespace jounce::cli_test {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";
const std::string cam = examples + "pmc600-cam/cam.toml";
const std::string via = examples + "generators/08-via.toml";  ///< two axes, x and y

/// The content of a file.
inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A run of the program: its exit status, and its two streams.
struct Result {
  int status;
  std::string out;
  std::string err;
};

/// Runs the program in a new folder, which must contain only the files that the test expects.
class Program : public ::testing::Test {
 protected:
  Result run(const std::string& arguments) {
    const std::string err = folder.string() + ".err";
    const std::string command =
        "cd " + folder.string() + " && " JOUNCE_EXE " " + arguments + " 2> " + err;
    std::FILE* pipe = popen(command.c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    const int status = WEXITSTATUS(pclose(pipe));
    const Result result{status, out, slurp(err)};
    std::filesystem::remove(err);
    return result;
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
  }

  /// The names of the files in the folder, sorted.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  test::TemporaryFolder own_;

 protected:
  const std::filesystem::path& folder = own_.path();
};

}  // namespace jounce::cli_test
