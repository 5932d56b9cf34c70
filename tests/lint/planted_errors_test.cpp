// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/base/file.hpp"
#include "jounce/lint/find_files.hpp"
#include "jounce/lint/lint.hpp"

// Plants up to six independent errors in specs of all kinds. Each one must be reported exactly once, at its line.
namespace jounce::planted_errors_test {
namespace {

using ::testing::ElementsAreArray;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// An error that can be planted in a line: a pattern of the line, and its replacement.
struct Mistake {
  const char* name;
  std::regex in;
  const char* by;
};

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all{
      {"unknown key in a section", std::regex(R"(^([a-z_]+ = [^\[{]*)$)"), "zzq = 1"},
      {"unknown key in a table", std::regex(R"(^(\w+ = \{) )"), "$1 zzq = 1, "},
      {"unknown unit",
       std::regex(R"(^(velocity|acceleration|jerk|master|slave|to) = ("?)[-\d.e]+.*$)"),
       "$1 = \"1 xyz\""},
      {"unit of another quantity",
       std::regex(R"(^(velocity|acceleration|jerk|geo_velocity|geo_acceleration) = "?[-\d.e]+.*$)"),
       "$1 = \"1 cd\""},
      {"unit in a table", std::regex(R"(^((?:start|end) = \{ master = )[-\d.e]+(?=[, ]))"),
       "$1\"1 kg\""},
      {"unknown law", std::regex(R"(^law = ".*$)"), "law = \"wobble\""},
      {"wrong type", std::regex(R"(^(tolerance|intervals|settle|cycle|periodic) = .*$)"),
       "$1 = [1]"},
      {"wrong value", std::regex(R"(^(geo_velocity|geo_acceleration) = "?[\d.e]+.*$)"), "$1 = -1"},
  };
  return all;
}

/// An index below `count`.
std::size_t draw(std::mt19937& random, std::size_t count) {
  return random() % count;
}

bool is_protected(const std::string& line) {
  for (const char* word :
       {"jounce", "kind", "name", "key", "spec", "units", "position = \"", "time = \""})
    if (line.starts_with(word)) return true;
  return false;
}

struct Planted {
  std::vector<std::string> lines;
  std::vector<int> at = {};  ///< lines of the errors, from 1
  std::vector<std::string> what = {};
};

/// The spec with up to `count` errors, at most one in a line.
Planted planted(std::vector<std::string> lines, std::size_t count, std::mt19937& random) {
  std::vector<std::string> marks(lines.size());
  for (std::size_t tries = 0; tries < 200 && count > 0; ++tries) {
    const std::size_t line = draw(random, lines.size());
    const Mistake& mistake = mistakes()[draw(random, mistakes().size())];
    if (!marks[line].empty() || is_protected(lines[line]) ||
        !std::regex_search(lines[line], mistake.in))
      continue;
    // The law determines whether a segment may have a file of points, and with which keys.
    const auto has_points = [](const std::string& each) { return each.starts_with("points = \""); };
    if (std::string(mistake.name) == "unknown law" &&
        std::any_of(lines.begin(), lines.end(), has_points))
      continue;
    const bool inserts = std::string(mistake.by) == "zzq = 1";
    // A section has one unknown key: the same key twice is an error of the syntax.
    if (inserts) {
      std::size_t top = line;
      while (top > 0 && !lines[top].starts_with("[")) --top;
      bool other = false;
      for (std::size_t i = top; i < lines.size() && (i == top || !lines[i].starts_with("[")); ++i)
        other = other || lines[i] == "zzq = 1";
      if (other) continue;
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(line) + 1, mistake.by);
      marks.insert(marks.begin() + static_cast<std::ptrdiff_t>(line) + 1, mistake.name);
    } else {
      lines[line] = std::regex_replace(lines[line], mistake.in, mistake.by);
      marks[line] = mistake.name;
    }
    --count;
  }
  Planted result{std::move(lines)};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (marks[i].empty()) continue;
    result.at.push_back(static_cast<int>(i) + 1);
    result.what.push_back(std::to_string(i + 1) + ": " + marks[i]);
  }
  return result;
}

/// The lines of the errors, in the order of the report.
std::vector<int> reported(const FileResult& file) {
  std::vector<int> lines;
  for (const Diagnostic& each : file.diagnostics)
    if (each.level == Level::error) lines.push_back(each.place.line);
  return lines;
}

std::vector<std::string> specs() {
  std::vector<std::string> all;
  for (const std::string& file : find_files({JOUNCE_SOURCE_DIR "/examples"}))
    if (file.ends_with(".toml")) all.push_back(file);
  return all;
}

TEST(PlantedErrors, AreReportedOnceInTheirOrder) {
  const Examine nothing = [](std::vector<Input>& axes) { return std::vector<Report>(axes.size()); };
  std::mt19937 random(25);
  std::size_t all = 0;
  for (const std::string& file : specs()) {
    if (lint_file(file, nothing).worst() == Level::error) continue;  // its error is its purpose
    const std::vector<std::string> lines = lines_of(read_file(file));
    for (std::size_t count = 1; count <= 6; ++count) {
      const Planted spec = planted(lines, count, random);
      if (spec.at.empty()) continue;
      const FileResult result = lint_text(file, text_of(spec.lines), nothing);
      EXPECT_THAT(reported(result), ElementsAreArray(spec.at))
          << file << "\n"
          << ::testing::PrintToString(spec.what) << "\n"
          << [&] {
               std::string messages;
               for (const Diagnostic& each : result.diagnostics) messages += each.message + "\n";
               return messages;
             }();
      all += spec.at.size();
    }
  }
  EXPECT_GT(all, 1000U);
}

}  // namespace
}  // namespace jounce::planted_errors_test
