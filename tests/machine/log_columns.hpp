// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace jounce::test {

/// The columns of a tick log by their names without units, read with code of its own.
struct LogColumns {
  explicit LogColumns(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    std::vector<std::string> head = cells(line);
    for (std::string& name : head) name = name.substr(0, name.find(" ["));
    while (std::getline(in, line)) {
      const std::vector<std::string> row = cells(line);
      for (std::size_t k = 0; k < head.size(); ++k) text[head[k]].push_back(row.at(k));
    }
  }

  /// A column of numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const {
    std::vector<double> values;
    for (const std::string& cell : text.at(name)) values.push_back(std::stod(cell));
    return values;
  }

  std::map<std::string, std::vector<std::string>> text{};

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> found;
    std::string cell;
    std::istringstream in(line + ",");
    while (std::getline(in, cell, ',')) found.push_back(cell);
    return found;
  }
};

}  // namespace jounce::test
