// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/samples_csv.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "jounce/base/units.hpp"
#include "jounce/io/detail/table_parts.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

using profiles_detail::rounded_sum;

constexpr std::size_t block = 1024;
constexpr double most_rows = 1e8;

void append(std::string& text, double value, char before) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  text += before;
  text.append(digits, end.ptr);
}

std::string names_line(const TableFile& file) {
  const auto names = io_detail::column_names(file.table.axis(), Interpolation::quintic_hermite);
  std::string text = names[0] + " [" + file.units.x + "]";
  for (int order = 0; order < 3; ++order)
    text += "," + names[static_cast<std::size_t>(order) + 1] + " [" +
            rate_unit(file.units.position, file.units.x, order) + "]";
  return text;
}

std::string with_space(const std::string& unit) {
  return unit.empty() ? "" : " " + unit;
}

/// Number of instants start + k step before the end, and the end. `unit`: of the step.
std::size_t rows_of(const Table& table, const std::string& unit, double step) {
  require_positive("every", step);
  if (step > table.length() * (1 + rounded_sum))
    throw InputError("every", number(step) + with_space(unit),
                     "must be at most " + six_digits_down(table.length()) + with_space(unit) +
                         ", the length of the table");
  const double steps = std::ceil(table.length() / step * (1 - rounded_sum));
  if (!(steps < most_rows))
    throw InputError("every", step, "makes more than 100 million rows: give a greater interval");
  return static_cast<std::size_t>(steps) + 1;
}

/// Instants of the rows: the last is the end, wherever the steps fall.
double instant(const Table& table, double step, std::size_t k) {
  return std::min(table.start() + static_cast<double>(k) * step, table.end());
}

}  // namespace

std::string samples_csv(const TableFile& file, double step) {
  const Table& table = file.table;
  const std::size_t rows = rows_of(table, file.units.x, step);
  std::string text = names_line(file);
  std::array<std::array<double, block>, 4> columns;
  auto& [x, p, v, a] = columns;
  for (std::size_t first = 0; first < rows; first += block) {
    const std::size_t n = std::min(block, rows - first);
    for (std::size_t k = 0; k < n; ++k) x[k] = instant(table, step, first + k);
    table.sample(std::span(x).first(n), std::span(p).first(n), std::span(v).first(n),
                 std::span(a).first(n));
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < columns.size(); ++i)
        append(text, columns[i][k], i == 0 ? '\n' : ',');
  }
  return text + "\n";
}

std::string samples_csv(const TableFile& file, const std::string& step) {
  try {
    return samples_csv(file, quantity(step, file.units.x));
  } catch (const InputError& error) {
    throw InputError("every", step, error.rule());
  }
}

}  // namespace jounce
