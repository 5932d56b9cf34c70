// SPDX-License-Identifier: Apache-2.0
#include "executor/record/log_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace jounce::test {
namespace {

double number(std::string_view text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

Line line_of(std::string_view text) {
  std::string_view cells[14];
  for (std::string_view& cell : cells) {
    const std::size_t comma = text.find(',');
    cell = text.substr(0, comma);
    text.remove_prefix(std::min(text.size(), cell.size() + 1));
  }
  return {static_cast<std::int64_t>(number(cells[0])),
          cells[2],
          number(cells[5]),
          number(cells[6]),
          number(cells[7]),
          cells[8] != "0",
          cells[9],
          cells[13] == "1"};
}

}  // namespace

std::optional<Line> Lines::next() {
  const std::string_view line = text();
  return line.empty() ? std::nullopt : std::optional(line_of(line));
}

std::string_view Lines::text() {
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  return line;
}

double time_to_rest(double v, double a, double acceleration, double jerk) {
  const double first = std::abs(a) / jerk;
  const double faster = std::abs(v) + std::abs(a) * first / 2;
  return 1.01 *
         (first + faster / acceleration + 2 * acceleration / jerk + std::sqrt(2 * faster / jerk));
}

}  // namespace jounce::test
