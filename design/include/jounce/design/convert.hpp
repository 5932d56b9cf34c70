// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/design/input.hpp"
#include "jounce/pvt/reduce.hpp"

namespace jounce {

/// Requirements for a converted table.
struct Conversion {
  /// Interpolation of the result; nullopt: the one of the format (rule_of() in
  /// controllers/exchange/exchange_format.hpp), and cubic_hermite without a format.
  std::optional<Interpolation> rule = {};
  /// Requirements for new knots; the result has as few knots as possible. The rule of the target is
  /// `rule` above.
  std::optional<Target> target = {};
  std::size_t intervals = 0;  ///< number of equal intervals of new knots; 0: not requested
  Units units = {};  ///< units of the result; for a file without units, the units of its numbers;
                     ///< "": unchanged
  bool periodic = false;  ///< true: the motion repeats, although the file does not define this
  const ExchangeFormat* format = nullptr;  ///< format of a controller; null: CSV or JSON of Jounce
  std::string given_counts = {};           ///< CountedInput::sizes
};

/// A converted table, and its difference from the input.
struct Converted {
  TableFile file;  ///< the table, with its units and names
  /// Error in the units of the input. If the knots and the rule are unchanged, and the controller
  /// does not join the knots by a spline, this is the error of the input: for a spec, the error of
  /// its table; for a table, nullopt.
  std::optional<SampleError> error = {};
  /// Greatest permitted error of the position, in the unit of the input, for the format of a
  /// controller, and for knots that get another rule or equal intervals: the tolerance of the
  /// target; if it has none, a ten-thousandth of the stroke, but at least one count.
  std::optional<double> limit = {};
  /// Sizes of the counts of a format in counts, and a tolerance that follows from the resolution of
  /// the position, as a sentence; otherwise "".
  std::string counts = {};
  std::string given_counts = {};  ///< Conversion::given_counts
  /// Limits that the table exceeds between its knots, and that the motion keeps: [limits] and, with
  /// [master], [limits.slave]. The values are in the units of the input.
  Report exceeded = {};

  /// True if the error is within its limit, and the table within the limits of the motion.
  [[nodiscard]] bool keeps() const { return within_limit() && exceeded.findings.empty(); }
  /// True if the error is within the limit.
  [[nodiscard]] bool within_limit() const { return !error || !limit || error->position <= *limit; }
};

/// Returns the table of an input with other knots, another interpolation, or other units. The knots
/// stay, unless the rule or the target requires others.
///
/// For the format of a controller, the knots stay if the controller then plays the motion within
/// the limit; otherwise the fewest knots within the limit replace them. If the controller cannot
/// store so many knots, the error exceeds the limit (within_limit()). The table has the units and
/// the counts of the file. If the controller joins the knots by a spline (KnotJoin), the error and
/// its tolerance apply to this spline, with the numbers rounded as in the file. If the end
/// conditions of the spline are not documented, they are assumed to be natural, or periodic if the
/// cam repeats. For a format in counts, target->x_step and p_step are the sizes of a count.
///
/// Throws InputError with the name of a member of Target ("tolerance", "x_step", ...), or with
/// "master_unit" or "position_unit" for a unit that is unknown or of another quantity.
Converted converted(const Input& input, const Conversion& conversion);

/// Returns the parts of the input that a file in this format does not contain, one phrase for each.
std::vector<std::string> losses(const Input& input, const ExchangeFormat* format,
                                const Table& made);

/// Returns the certified error of a conversion as a sentence. If the conversion has no error, the
/// sentence states that the numbers are unchanged, or only converted to other units.
std::string error_text(const Converted& made, const Labels& labels);

/// The format of an output file.
struct TableForm {
  /// The name of a format of Jounce (own_forms() in jounce/io/table_file.hpp), "points" (CSV of
  /// segments with types), or the name of the controller's `format`.
  std::string name = "csv";
  const ExchangeFormat* format = nullptr;  ///< format of a controller; null for the other forms
};

/// Returns the form with this name; if the name is empty, the form for the extension of `path`, by
/// default CSV.
TableForm table_form(const std::string& name, const std::string& path);

/// Returns the interpolation with this name; nullopt if no interpolation has this name.
std::optional<Interpolation> interpolation_named(const std::string& word);

/// Returns the interpolation of a table in this form, from the first of these sources that gives
/// one: the controller's format; `wanted`; the controller (controller_table() in table_target.hpp)
/// with the name `controller`; `table`.
Interpolation rule_for(const TableForm& form, std::optional<Interpolation> wanted,
                       const std::string& controller, const Table& table);

/// Returns the text of a file in this form; with `every`, samples (samples_csv()), for which the
/// form must be CSV. Throws InputError like exchange_text(), points_text() and samples_csv().
std::string form_text(const TableForm& form, const TableFile& file, const std::string& every = "");

/// Throws InputError ("master_unit", "position_unit") if a unit of the table is missing.
void require_units(const TableFile& file);

/// Returns all parts of an input that a file in this form does not contain: the unread parts of the
/// input file, and losses() of the format. `sampled` is true if the file has samples of the table.
std::vector<std::string> all_losses(const Input& input, const TableForm& form, const Table& made,
                                    bool sampled = false);

/// Returns the names of all forms: "csv", "json", "npy", "points", and the names of the
/// controllers' formats.
std::vector<std::string> form_names();
/// Returns the endings by which table_form() recognizes a form: ".csv, .json, .st, ...". If `named`
/// is true, the name of the form follows each ending, unless both are the same.
std::string known_endings(bool named = false);
/// True if a path has one of the known endings, or is "-".
bool has_known_ending(const std::string& path);
/// Throws InputError (key "path") unless has_known_ending(). `input`: the file to convert.
void require_known_ending(const std::string& path, const std::string& input);
/// Returns the output of `jounce convert`: input, form, knots, error, and one line for each loss.
/// If the error exceeds its limit, one more line states this limit. Each limit of the motion that
/// the table exceeds has one more line.
std::string conversion_text(const Input& input, const Converted& made, const TableForm& form,
                            const std::vector<std::string>& losses);

/// Returns the reason why a conversion that does not keep its limits (Converted::keeps()) is not
/// written, and the options that help.
std::string not_written_text(const Conversion& wanted, const Converted& made);

/// Returns the contents of conversion_text() as a JSON object; `path` is the name of the output
/// file.
std::string conversion_json(const Converted& made, const TableForm& form, const std::string& path,
                            const std::vector<std::string>& losses);

}  // namespace jounce
