// SPDX-License-Identifier: Apache-2.0
#include "design/src/convert/for_controller.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>

#include "jounce/base/input_errors.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/points_text.hpp"
#include "jounce/profiles/curve/difference.hpp"
#include "jounce/profiles/detail/digits_beside.hpp"
#include "jounce/profiles/detail/evaluate.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/pvt/fill.hpp"

#include "design/src/check/table_check.hpp"
#include "design/src/convert/missing_units.hpp"
#include "design/src/convert/time_rounding.hpp"

namespace jounce::design_detail {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
using profiles_detail::rounded_value;

constexpr double share_of_stroke = 1e-4;    ///< default tolerance, as a share of the stroke
constexpr double share_of_limit = 0x1p-20;  ///< by which numbers in REAL may exceed a limit

bool joins_by_spline(const ExchangeFormat& format) {
  return format.join == KnotJoin::spline || format.join == KnotJoin::clamped_spline;
}

Range travel_of(const Input& input) {
  return std::visit([](const auto& curve) { return extrema(curve, 0); }, *input.curve);
}

/// The spline by which the controller joins the knots of a table. Its ends have the slopes of the
/// table; if the ends are not documented, it is periodic if the cam repeats, otherwise natural.
/// Numbers are rounded as in the file.
Columns controller_spline(const ExchangeFormat& format, const Table& made) {
  Columns columns{made.columns().x, made.columns().p, std::vector<double>(made.size()), {}};
  if (format.single)
    for (auto* column : {&columns.x, &columns.p})
      for (double& value : *column) value = static_cast<double>(static_cast<float>(value));
  const bool given = format.join == KnotJoin::clamped_spline;
  std::vector<std::optional<double>> ends(given ? made.size() : 0);
  if (given) ends.front() = made.columns().v.front(), ends.back() = made.columns().v.back();
  const bool periodic = !given && repeats(made.outside());
  columns.v = filled({.axis = Domain::master,
                      .x = columns.x,
                      .p = columns.p,
                      .v = std::move(ends),
                      .filling = periodic ? Filling::periodic : Filling::natural})
                  .table.columns()
                  .v;
  return columns;
}

/// The size of a unit in another one; 1 if one of them is not known.
double size_of(const std::string& unit, const std::string& in) {
  return unit.empty() || in.empty() ? 1.0 : conversion(unit, in);
}

/// The columns in the units of the input.
Columns in_units_of(const TableFile& input, const Units& units, Columns columns) {
  const double x = size_of(units.x, input.units.x);
  const double p = size_of(units.position, input.units.position);
  for (double& value : columns.x) value *= x;
  for (double& value : columns.p) value *= p;
  for (double& value : columns.v) value *= p / x;
  return columns;
}

/// Sizes of the controller's steps, in the units of the input; 0: no steps.
struct Steps {
  double x = 0, p = 0;
};

/// Conversion of one input for one controller.
class ForController {
 public:
  ForController(const Input& input, const Conversion& wanted)
      : input_(input), wanted_(wanted), format_(*wanted.format), labels_(labels()) {
    require_axis();
    require_applicable(wanted.target.value_or(Target{}));
    require_units();
    if (format_.x == Numbers::of_unit)
      file_units_.x = file_unit("master_unit", labels_.x, format_.x_unit, wanted.units.x);
    if (format_.p == Numbers::of_unit)
      file_units_.position = file_unit("position_unit", labels_.position, format_.position_units,
                                       wanted.units.position);
    steps_ = steps();
    target_ = wanted.target.value_or(Target{});
    target_.rule = *wanted.rule;
    target_.quadratic = format_.join == KnotJoin::quadratic;
    target_.x_step = steps_.x;
    if (format_.p != Numbers::of_unit) target_.p_step = target_.v_step = 0;
    if (format_.p == Numbers::whole) target_.p_step = steps_.p;
    if (format_.p == Numbers::whole && wanted.rule != Interpolation::linear)
      target_.v_step =
          steps_.p * (format_.x_unit[0] == '\0' ? 1 : conversion(labels_.x, format_.x_unit));
    const double usual = default_limit();
    limit_ = target_.tolerance.value_or(std::max(usual, target_.p_step));
    is_one_count_ = !target_.tolerance && limit_ > usual;
  }

  Converted made() {
    Converted result = played(knots());
    // Knots that keep a tolerance with the rule of the table may not keep it with the spline: then
    // more knots are used.
    if (joins_by_spline(format_) && may_add_knots())
      for (int i = 0; i < 30 && !keeps(result) && result.file.table.size() < format_.most; ++i) {
        for (std::optional<double>* tolerance : {&target_.tolerance, &target_.velocity_tolerance})
          if (*tolerance) **tolerance /= 2;
        result = played(fewest_knots());
      }
    result.limit = limit_;
    result.exceeded = check_converted(moved_on(result.file), input_,
                                      {format_.single ? share_of_limit : 0, rises_});
    if (is_one_count_ && result.counts.empty())
      result.counts = "tolerance: " + number(limit_) + unit_after(labels_.position) +
                      ", the resolution of the position";
    return result;
  }

 private:
  /// Throws for a table over the wrong variable. The table may be points over time that a file
  /// without a time column gives over a master.
  void require_axis() const {
    const Table& table = input_.table.table;
    if (format_.axis == Domain::time && table.axis() == Domain::master &&
        is_convertible(labels_.x, "s"))
      throw InputError("format", format_.name,
                       "is for motions over time; this table is a cam over a master in " +
                           labels_.x +
                           ": for a motion over time, name the first column of a CSV file time, "
                           "give it to a spec of kind pvt (key points), and convert the spec");
    jounce::require_axis(format_, table);
  }

  /// Throws one error for a file that names neither of its units, if the format needs both.
  void require_units() const {
    if (format_.x != Numbers::of_unit || format_.p != Numbers::of_unit) return;
    const std::string x = format_.x_unit;
    const std::string position = format_.position_units;
    if (x.empty() || position.empty() || !labels_.x.empty() || !labels_.position.empty()) return;
    throw both_units_missing(x.substr(0, x.find(' ')), position.substr(0, position.find(' ')));
  }

  /// Throws for a requirement that the format cannot have.
  void require_applicable(const Target& given) const {
    const bool has_velocities =
        rule_of(format_) != Interpolation::linear && !joins_by_spline(format_);
    if (given.v_step > 0 && (!has_velocities || format_.p != Numbers::of_unit))
      throw InputError("v_step", given.v_step,
                       std::string("does not apply to the format ") + format_.name +
                           (has_velocities ? ", whose velocities follow from its counts"
                                           : ", which contains no velocities"));
    if (given.spacing > 0 && (format_.equal_steps || wanted_.intervals > 0))
      throw InputError("spacing", given.spacing,
                       "does not apply to knots at equal distances: give --most or --intervals");
  }

  /// The units of the input. For a file without units, the user states them.
  [[nodiscard]] Units labels() const {
    Units units = input_.table.units;
    if (units.x.empty()) units.x = wanted_.units.x;
    if (units.position.empty()) units.position = wanted_.units.position;
    return units;
  }

  /// The unit in the file: the first of `possible` that the unit of the table converts to; `wanted`
  /// if the format has no fixed units.
  [[nodiscard]] std::string file_unit(const char* key, const std::string& of_table,
                                      const std::string& possible,
                                      const std::string& wanted) const {
    if (possible.empty()) return wanted;
    if (of_table.empty())
      throw InputError(key, "",
                       "is missing: the file names no unit. Give one, such as " +
                           possible.substr(0, possible.find(' ')));
    std::istringstream units(possible);
    for (std::string unit; units >> unit;)
      if (unit == wanted || (wanted.empty() && unit == of_table)) return unit;
    units = std::istringstream(possible);
    for (std::string unit; units >> unit;)
      if (is_convertible(of_table, unit)) return unit;
    throw InputError(key, of_table,
                     std::string("is not possible in the format ") + format_.name +
                         ", whose units are " + possible);
  }

  [[nodiscard]] Steps steps() const {
    Steps all;
    const Target given = wanted_.target.value_or(Target{});
    if (format_.x_step > 0) {
      all.x = format_.x_step * conversion(format_.x_unit, labels_.x);
      const double multiple = given.x_step / all.x;
      if (std::abs(multiple - std::round(multiple)) > rounded_input * multiple)
        throw InputError("x_step", given.x_step,
                         "must be a multiple of " + number(all.x) + " " + labels_.x +
                             ", the step of the controller");
      all.x = std::max(all.x, given.x_step);
    } else {
      all.x = given.x_step;
    }
    std::vector<InputError> missing;
    if (format_.x != Numbers::of_unit)
      all.x = count("x_step", "first column", labels_.x, given.x_step, missing);
    if (format_.p != Numbers::of_unit)
      all.p = count("p_step", "position", labels_.position, given.p_step, missing);
    if (missing.size() == 1) throw InputError(missing.front());
    if (!missing.empty()) throw InputErrors(missing);
    return all;
  }

  /// Size of one count, as the user gives it, or by a unit that is a count. Adds the error of a size
  /// that is not given to `missing`.
  [[nodiscard]] double count(const char* key, const char* what, const std::string& unit,
                             double given, std::vector<InputError>& missing) const {
    if (given > 0) return given;
    if (is_convertible("pulse", unit)) return conversion("pulse", unit);
    missing.emplace_back(key, "",
                         std::string("is missing: the format ") + format_.name + " has the " +
                             what + " in counts. Give the size of one count, such as 0.001" +
                             (unit.empty() ? "mm" : unit));
    return 1;
  }

  [[nodiscard]] double default_limit() const {
    const double usual = default_tolerance(input_);
    if (!format_.single) return usual;
    return std::max(usual, single_rounding * std::abs(travel_of(input_).peak().value));
  }
  static constexpr double single_rounding =
      0x1p-23;  ///< rounding of a REAL, as a share of its value

  [[nodiscard]] bool keeps(const Converted& made) const {
    return made.error->position <= limit_ &&
           (!wanted_.target || !wanted_.target->velocity_tolerance ||
            made.error->velocity <= *wanted_.target->velocity_tolerance);
  }

  /// True if the user requests neither knots nor a number of them.
  [[nodiscard]] bool chooses_knots() const {
    return wanted_.intervals == 0 && !target_.tolerance && !target_.velocity_tolerance &&
           !target_.most;
  }
  [[nodiscard]] bool may_add_knots() const {
    return wanted_.intervals == 0 && (target_.tolerance || target_.velocity_tolerance);
  }

  Sampled knots() {
    if (wanted_.intervals > 0) return equal_intervals(wanted_.intervals);
    if (format_.equal_steps) return equal_intervals(fewest_equal_intervals());
    if (!chooses_knots()) return fewest_knots();
    if (auto same = same_knots()) return *std::move(same);
    target_.tolerance = limit_;
    return fewest_knots();
  }

  /// The fewest knots for the target. A controller that cannot hold them gets its greatest number.
  Sampled fewest_knots() {
    Conversion conversion = wanted_;
    conversion.target = target_;
    Sampled made = within_default(conversion);
    if (made.table.size() > format_.most) made = best_of_most(std::move(conversion));
    return made.table.size() < format_.fewest ? equal_intervals(format_.fewest - 1) : made;
  }

  /// The knots for a target. If they cannot keep a tolerance that the user did not give, the error
  /// names the step or the spacing that the user gave.
  [[nodiscard]] Sampled within_default(const Conversion& conversion) const {
    const Target given = wanted_.target.value_or(Target{});
    try {
      return with_knots(input_, conversion);
    } catch (const InputError& error) {
      const bool is_spacing = given.spacing > 0;
      if (error.key() != "tolerance" || given.tolerance || (!is_spacing && given.x_step == 0))
        throw;
      throw InputError(is_spacing ? "spacing" : "x_step", is_spacing ? given.spacing : given.x_step,
                       "permits no knots within the default tolerance, " + rounded(limit_) +
                           unit_after(labels_.position) +
                           ": give a smaller value, or the tolerance that you permit");
    }
  }

  /// The best knots, as many as the controller can hold. If so few cannot keep the dwells of the
  /// motion, they are at equal distances.
  Sampled best_of_most(Conversion conversion) {
    conversion.target->tolerance.reset();
    conversion.target->velocity_tolerance.reset();
    conversion.target->most = format_.most;
    try {
      return with_knots(input_, conversion);
    } catch (const InputError& error) {
      if (error.key() != "most") throw;
      return equal_intervals(format_.most - 1);
    }
  }

  /// The knots of the input, if they are good enough for the controller.
  [[nodiscard]] std::optional<Sampled> same_knots() {
    const Table& table = input_.table.table;
    if (target_.p_step > 0 || target_.v_step > 0 || !on_steps(table.columns().x) ||
        table.size() > format_.most || table.size() < format_.fewest)
      return std::nullopt;
    for (std::size_t i = 1; i < table.size() && target_.spacing > 0; ++i)
      if (table.columns().x[i] - table.columns().x[i - 1] < target_.spacing) return std::nullopt;
    if (target_.quadratic && !is_quadratic(table)) return std::nullopt;
    Sampled made = table.rule() == wanted_.rule
                       ? Sampled{table, input_.error.value_or(SampleError{})}
                       : with_knots(input_, {.rule = wanted_.rule});
    if (joins_by_spline(format_) ? !keeps(played(made)) : made.error.position > limit_)
      return std::nullopt;
    is_unchanged_ = table.rule() == wanted_.rule;
    return made;
  }

  [[nodiscard]] bool on_steps(const std::vector<double>& x) const {
    return steps_.x == 0 || std::all_of(x.begin(), x.end(), [&](double each) {
             const double steps = each / steps_.x;
             return std::abs(steps - std::round(steps)) <= rounded_input;
           });
  }

  static bool is_quadratic(const Table& table) {
    if (table.rule() != Interpolation::cubic_hermite) return false;
    try {
      return !points_of(table).empty();
    } catch (const InputError&) {
      return false;
    }
  }

  /// Equal intervals, with positions in whole counts if the controller has such.
  [[nodiscard]] Sampled equal_intervals(std::size_t n) const {
    if (const auto counts = whole_travel(); counts && *counts % n != 0)
      throw InputError("intervals", std::to_string(n),
                       "must divide the travel of the first column, " + std::to_string(*counts) +
                           " steps of the controller");
    return std::visit(
        [&](const auto& curve) {
          Sampled made = sample(curve, *wanted_.rule, n);
          if (target_.p_step == 0 && target_.v_step == 0) return made;
          Columns columns = made.table.columns();
          for (auto& [column, step] :
               {std::pair{&columns.p, target_.p_step}, {&columns.v, target_.v_step}})
            for (double& value : *column)
              if (step > 0) value = step * std::round(value / step);
          return certified(curve, *wanted_.rule, std::move(columns));
        },
        *input_.curve);
  }

  /// Travel of the first column in steps; none if the controller has none.
  [[nodiscard]] std::optional<std::size_t> whole_travel() const {
    if (steps_.x == 0) return std::nullopt;
    const Table& table = input_.table.table;
    const double travel = (table.end() - table.start()) / steps_.x;
    if (std::abs(travel - std::round(travel)) > rounded_input * travel)
      throw InputError("x_step", steps_.x,
                       "must divide the travel of the first column, " +
                           number(table.end() - table.start()) + " " + labels_.x);
    return static_cast<std::size_t>(std::llround(travel));
  }

  /// The least number of equal intervals within the tolerance, or the greatest possible one.
  [[nodiscard]] std::size_t fewest_equal_intervals() const {
    const std::size_t most = std::min(format_.most, target_.most.value_or(format_.most)) - 1;
    std::vector<std::size_t> possible;
    const auto counts = whole_travel();
    for (std::size_t n = std::max<std::size_t>(format_.fewest - 1, 1); n <= most; ++n)
      if (!counts || (*counts % n == 0 &&
                      static_cast<double>(*counts) <= format_.most_step * static_cast<double>(n)))
        possible.push_back(n);
    if (possible.empty())
      throw InputError("x_step", steps_.x,
                       "leaves no possible number of equal intervals: there may be at most " +
                           std::to_string(most) + ", of at most " + number(format_.most_step) +
                           " counts, in a travel of " + std::to_string(*counts) + " counts");
    if (target_.most && !target_.tolerance) return possible.back();
    const auto fits = [&](std::size_t n) { return equal_intervals(n).error.position <= limit_; };
    // The error falls about with the square of the number: few trials find the place.
    std::size_t first = 0, end = 1;
    while (end < possible.size() && !fits(possible[end - 1])) first = end, end *= 2;
    end = std::min(end, possible.size());
    const auto found = std::partition_point(possible.begin() + static_cast<std::ptrdiff_t>(first),
                                            possible.begin() + static_cast<std::ptrdiff_t>(end),
                                            [&](std::size_t n) { return !fits(n); });
    return found == possible.end() ? possible.back() : *found;
  }

  /// The result as the controller plays it, in the units of the file.
  [[nodiscard]] Converted played(Sampled made) {
    Conversion conversion = wanted_;
    conversion.units = file_units_;
    Units units = input_.table.units;
    if (units.x.empty() && is_unit(labels_.x)) units.x = labels_.x;
    if (units.position.empty() && is_unit(labels_.position)) units.position = labels_.position;
    Converted result{{std::move(made.table), units, input_.table.provenance}, made.error};
    if (is_unchanged_) result.error = input_.error;
    result.file = in_units(std::move(result.file), conversion);
    if (format_.x_rounding > 0) round_x(result);
    if (joins_by_spline(format_)) play_spline(result);
    if (format_.p != Numbers::of_unit) count_columns(result);
    return result;
  }

  /// If the spline of the controller is documented, it becomes the table. Its distance from the
  /// input is the error.
  void play_spline(Converted& result) const {
    Columns spline = controller_spline(format_, result.file.table);
    result.error = std::visit(
        [&](const auto& curve) {
          return certified(curve, Interpolation::cubic_hermite,
                           in_units_of(input_.table, result.file.units, spline))
              .error;
        },
        *input_.curve);
    if (format_.join == KnotJoin::clamped_spline)
      result.file.table = Table(Domain::master, Interpolation::cubic_hermite,
                                result.file.table.outside(), std::move(spline));
  }

  /// Rounds the first column to the digits of the file. Each knot moves along the table by half a
  /// digit at most, with its velocity and its acceleration, so that the rounded table has the
  /// derivatives of the given one. The difference of both is added to the error.
  void round_x(Converted& result) {
    const Table before = result.file.table;
    const double first = before.start();
    Columns columns = before.columns();
    for (double& x : columns.x) x -= first;
    const Table given(before.axis(), before.rule(), before.outside(), columns);
    for (std::size_t i = 0; i < columns.x.size(); ++i) move_knot(given, i, columns);
    std::vector<double> moved;
    for (std::size_t i = 0; i < columns.x.size(); ++i)
      moved.push_back(columns.x[i] - given.columns().x[i]);
    rises_ = time_rounding(given, moved);
    const double p = size_of(result.file.units.position, labels_.position);
    const double x = size_of(result.file.units.x, labels_.x);
    for (Jet& rise : rises_)
      for (std::size_t k = 0; k < rise.size(); ++k)
        rise[k] *= p / std::pow(x, static_cast<double>(k));
    Table rounded(before.axis(), before.rule(), before.outside(), std::move(columns));
    if (rounded.columns().x != given.columns().x) add_error(result, given, rounded);
    result.file.table = std::move(rounded);
  }

  void move_knot(const Table& given, std::size_t i, Columns& columns) const {
    const double x = given.columns().x[i];
    const double rounded_x = std::round(x / format_.x_rounding) * format_.x_rounding;
    const double d = rounded_x - x;
    const std::size_t along = motion_of_knot(given, i);
    const Jet jet = profiles_detail::evaluate(given.segment(along), along == i ? 0 : 1);
    columns.x[i] = rounded_x;
    if (std::abs(d) <= rounded_value * std::abs(x)) return;  // a whole digit already
    columns.p[i] = jet[0] + d * (jet[1] + d * (jet[2] / 2 + d * jet[3] / 6));
    if (!columns.v.empty()) columns.v[i] = jet[1] + d * (jet[2] + d * jet[3] / 2);
    if (!columns.a.empty()) columns.a[i] = jet[2] + d * jet[3];
  }

  /// States a peak that the rounding of the times raises. `size`: of its unit in that of the input.
  void state_rise(Converted& result, const Change& change, std::size_t order, double size) const {
    const double before = std::abs(change.before.peak().value);
    const double after = std::abs(change.after.peak().value);
    if (after <= before * (1 + share_of_limit)) return;
    const char* name = OverTime::names[order];
    const std::string unit =
        unit_after(rate_unit(labels_.position, labels_.x, static_cast<int>(order)));
    const std::string from = six_digits(size * before);
    result.counts += (result.counts.empty() ? "" : "; ") + std::string("rounding of the times: ") +
                     name + " up to " + digits_beside(size * after, from) + unit + " instead of " +
                     from + unit;
  }

  /// Adds the difference of both tables to the error of the result.
  void add_error(Converted& result, const Table& given, const Table& rounded) const {
    const Changes changes = given.axis() == Domain::time
                                ? compare(given.curve<OverTime>(), rounded.curve<OverTime>())
                                : compare(given.curve<OverMaster>(), rounded.curve<OverMaster>());
    const Units& from = result.file.units;
    const double p = size_of(from.position, labels_.position);
    const double x = size_of(from.x, labels_.x);
    if (!result.error) result.error = SampleError{};
    const double position = p * std::abs(changes[0].largest.value);
    if (position > result.error->position)
      result.error->where = input_.table.table.start() + x * changes[0].largest.where;
    result.error->position += position;
    result.error->velocity += p / x * std::abs(changes[1].largest.value);
    for (const std::size_t order : {2U, 3U})
      state_rise(result, changes[order], order, p / std::pow(x, static_cast<double>(order)));
  }

  /// The table on which the controller moves, in the units of the input.
  [[nodiscard]] Table moved_on(const TableFile& file) const {
    const Table& table = file.table;
    const bool spline = joins_by_spline(format_);
    Columns columns = spline ? controller_spline(format_, table) : table.columns();
    if (format_.single && !spline)
      for (auto* column : {&columns.x, &columns.p, &columns.v, &columns.a})
        for (double& value : *column) value = static_cast<double>(static_cast<float>(value));
    const auto size = [](Numbers numbers, double step, const std::string& from,
                         const std::string& to) {
      return numbers != Numbers::of_unit ? step : size_of(from, to);
    };
    const double x = size(format_.x, steps_.x, file.units.x, labels_.x);
    const double p = size(format_.p, steps_.p, file.units.position, labels_.position);
    const double start = format_.x_rounding > 0 ? input_.table.table.start() : 0;
    for (double& value : columns.x) value = start + x * value;
    for (double& value : columns.p) value *= p;
    for (double& value : columns.v) value *= p / x;
    for (double& value : columns.a) value *= p / (x * x);
    return {table.axis(), spline ? Interpolation::cubic_hermite : table.rule(), table.outside(),
            std::move(columns)};
  }

  /// Changes the columns to counts.
  void count_columns(Converted& result) const {
    TableFile& file = result.file;
    const auto size = [](double step, const std::string& unit) {
      return "1 count is " + number(step) + unit_after(unit);
    };
    result.counts = "position: " + size(steps_.p, labels_.position);
    if (format_.x != Numbers::of_unit)
      result.counts = "master: " + size(steps_.x, labels_.x) + "; " + result.counts;
    if (is_one_count_) result.counts += "; tolerance: 1 count";
    Columns columns = file.table.columns();
    const auto divide = [](std::vector<double>& column, double step, bool whole) {
      for (double& value : column) value = whole ? std::round(value / step) : value / step;
    };
    const bool whole = format_.p == Numbers::whole;
    if (whole) require_counts(columns);
    const double x = format_.x == Numbers::of_unit ? 1 : steps_.x;
    divide(columns.x, x, format_.x == Numbers::whole);
    divide(columns.p, steps_.p, whole);
    divide(columns.v, steps_.p / x, whole);
    divide(columns.a, steps_.p / (x * x), false);
    file.table =
        Table(file.table.axis(), file.table.rule(), file.table.outside(), std::move(columns));
    file.units.position = "count";
    if (format_.x != Numbers::of_unit) file.units.x = "count";
  }

  /// Controllers hold counts in 32 bits.
  void require_counts(const Columns& columns) const {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    double greatest = 0;
    for (const double p : columns.p) greatest = std::max(greatest, std::abs(p));
    if (greatest <= most * steps_.p) return;
    throw InputError("p_step", steps_.p,
                     "must be at least " + six_digits_up(greatest / most) +
                         unit_after(labels_.position) + ": the controller holds counts in 32 bits");
  }

  static std::string unit_after(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

  const Input& input_;
  const Conversion& wanted_;
  const ExchangeFormat& format_;
  Units labels_;      ///< units of the input
  Units file_units_;  ///< units of the file; "": counts, or unknown
  Steps steps_;
  Target target_;
  double limit_ = 0;        ///< greatest permitted error of the position, in the unit of the input
  std::vector<Jet> rises_;  ///< by the rounding of the times, in the units of the input
  bool is_unchanged_ = false;
  bool is_one_count_ = false;  ///< true if one count exceeds the usual tolerance, and replaces it
};

}  // namespace

double default_tolerance(const Input& input) {
  const Range travel = travel_of(input);
  return std::max(share_of_stroke * (travel.max.value - travel.min.value),
                  rounded_sum * std::abs(travel.peak().value));
}

Converted for_controller(const Input& input, const Conversion& wanted) {
  return ForController(input, wanted).made();
}

}  // namespace jounce::design_detail
