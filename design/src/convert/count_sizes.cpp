// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/count_sizes.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// A factor that divides if its reciprocal is whole: 57 counts of 0.01 deg are 0.57 deg.
class Size {
 public:
  explicit Size(double factor) : factor_(factor), per_unit_(std::round(1 / factor)) {
    divides_ = std::abs(per_unit_ * factor - 1) <= profiles_detail::rounded_sum;
  }
  [[nodiscard]] double of(double counts) const {
    return divides_ ? counts / per_unit_ : counts * factor_;
  }
  [[nodiscard]] double factor() const { return factor_; }

 private:
  double factor_;
  double per_unit_;
  bool divides_ = false;
};

/// A column of the input, and the text of the size of its counts.
struct CountColumn {
  const char *key, *unit_option;
  std::string& text;
  std::string& unit;  ///< unit of the column
  const std::string& wanted;
  Numbers read, written;  ///< numbers in the files of the input and of the output

  [[nodiscard]] bool has_counts() const {
    return unit.empty() ? read != Numbers::of_unit : is_convertible(unit, "count");
  }
};

/// The size of a count, and the unit of the column; nullopt if the text is not the size of a count.
std::optional<Size> take_size(CountColumn& column) {
  const std::string own(quantity_unit(column.text));
  if (column.unit.empty() && column.read == Numbers::of_unit && column.wanted.empty() &&
      is_unit(own))
    throw InputError(column.key, column.text,
                     "is not the size of a count: the file has no counts in this column, and names "
                     "no unit for it. Add " +
                         std::string(column.unit_option) + " " + own);
  if (!column.has_counts() || !is_unit(own) || is_convertible(own, "count")) return std::nullopt;
  const std::string to = is_unit(column.wanted) ? column.wanted : own;
  double factor = 0;
  try {
    factor = quantity(column.text, to);
    require_positive(column.key, factor);
  } catch (const InputError& error) {
    throw InputError(column.key, column.text, error.rule());
  }
  column.unit = to;
  if (column.written == Numbers::of_unit) column.text.clear();
  return Size(factor);
}

Table sized(const Table& table, const Size& x, const Size& p) {
  Columns columns = table.columns();
  for (double& value : columns.x) value = x.of(value);
  for (double& value : columns.p) value = p.of(value);
  for (double& value : columns.v) value = p.of(value) / x.factor();
  for (double& value : columns.a) value = p.of(value) / (x.factor() * x.factor());
  return {table.axis(), table.rule(), table.outside(), std::move(columns)};
}

/// The input of another table from the same file.
Input with_table(Input input, TableFile file) {
  Input made = input_of(std::move(file), input.name);
  made.axis = std::move(input.axis);
  made.unread = std::move(input.unread);
  made.file = std::move(input.file);
  made.files = std::move(input.files);
  made.newer_spec = std::move(input.newer_spec);
  made.format = input.format;
  return made;
}

}  // namespace

CountedInput in_units_of_counts(Input input, TargetTexts& sizes, const Units& units,
                                const ExchangeFormat* format) {
  if (input.spec) return {std::move(input)};
  const auto numbers = [](const ExchangeFormat* of, Numbers ExchangeFormat::*column) {
    return of != nullptr ? of->*column : Numbers::of_unit;
  };
  TableFile file = input.table;
  const auto column = [&](const char* key, const char* option, std::string& text, std::string& unit,
                          const std::string& wanted, Numbers ExchangeFormat::*of) {
    return CountColumn{
        key, option, text, unit, wanted, numbers(input.format, of), numbers(format, of)};
  };
  CountColumn master =
      column("x_step", "--master-unit", sizes.x_step, file.units.x, units.x, &ExchangeFormat::x);
  CountColumn position = column("p_step", "--position-unit", sizes.p_step, file.units.position,
                                units.position, &ExchangeFormat::p);
  const std::optional<Size> x = take_size(master), p = take_size(position);
  if (!x && !p) return {std::move(input)};
  std::string text = "in the input, 1 count is ";
  const auto add = [&](const std::optional<Size>& size, const char* name, const std::string& unit) {
    if (size) text += six_digits(size->factor()) + " " + unit + " (" + name + ")";
  };
  add(x, "master", file.units.x);
  if (x && p) text += " and ";
  add(p, "position", file.units.position);
  file.table = sized(file.table, x.value_or(Size(1)), p.value_or(Size(1)));
  return {with_table(std::move(input), std::move(file)), std::move(text)};
}

void complete(Conversion& wanted, const TableForm& form, std::optional<Interpolation> rule,
              const TargetTexts& target, const CountedInput& given, const MemberName& name_of) {
  const Table& table = given.input.table.table;
  wanted.rule = rule_for(form, rule, target.controller, table);
  wanted.format = form.format;
  wanted.given_counts = given.sizes;
  if (!target.any()) return;
  Units units = given.input.labels.units;
  if (units.x.empty()) units.x = wanted.units.x;
  if (units.position.empty()) units.position = wanted.units.position;
  wanted.target = target_of(target, table.axis(), *wanted.rule, units, name_of);
}

}  // namespace jounce
