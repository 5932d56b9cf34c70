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

/// Contents of a converted table.
struct Conversion {
  Interpolation rule = Interpolation::cubic_hermite;
  std::optional<Target> target = {};  ///< new knots, as few as keep the target; its rule is `rule`
  std::size_t intervals = 0;          ///< new knots at this number of equal intervals; 0: not so
  Units units = {};  ///< units to convert to, or those that the file does not name; "": unchanged
  bool periodic = false;              ///< the motion repeats, although the file does not state it
  const CamFormat* format = nullptr;  ///< format of a controller; null: CSV or JSON of Jounce
};

/// A converted table, and its distance from the input.
struct Converted {
  TableFile file;
  std::optional<SampleError>
      error;  ///< in the units of the input; nullopt: bit for bit the knots of the input
};

/// The table of an input with other knots, another interpolation, or other units. Knots are kept unless the rule or the
/// target requires others. If the controller joins the knots by a spline (KnotJoin), the error is that of this spline,
/// with numbers rounded as in the file, and a tolerance holds for it. A spline whose ends are not documented is taken
/// as natural, or periodic if the cam repeats. Throws InputError with the name of a member of Target ("tolerance",
/// "x_step", ...), or "master_unit", "position_unit" for a unit that is unknown or measures something else.
Converted converted(const Input& input, const Conversion& conversion);

/// The parts of the input that a file in this format does not contain, one phrase each.
std::vector<std::string> losses(const Input& input, const CamFormat* format, const Table& made);

/// The certified error of a conversion as a sentence. Without an error: that the numbers are unchanged, or only
/// converted between units.
std::string error_text(const Converted& made, const Labels& labels);

/// The form in which a table is written.
struct TableForm {
  std::string name =
      "csv";  ///< "csv", "json", "points" (segments with types, CSV), or the name of the format
  const CamFormat* format = nullptr;  ///< format of a controller
};

/// The form of this name, or, if it is empty, by the end of the path; CSV if nothing else.
TableForm table_form(const std::string& name, const std::string& path);

/// The text of a file in this form. Throws InputError like exchange_text() and points_text().
std::string form_text(const TableForm& form, const TableFile& file);

/// Everything of an input that a file in this form does not contain: unread parts of its own file, and
/// losses() of the format. `sampled`: the file has samples of the table.
std::vector<std::string> all_losses(const Input& input, const TableForm& form, const Table& made,
                                    bool sampled = false);

/// The endings by which table_form() recognizes a form: ".csv, .json, .st, ...".
std::string known_endings();
/// True if a path has one of them, or is "-".
bool has_known_ending(const std::string& path);

/// The answer of `jounce convert`: input, form, knots, error and the losses, one a line.
std::string conversion_text(const Input& input, const Converted& made, const TableForm& form,
                            const std::vector<std::string>& losses);

/// The same as a JSON object; `path` is the name of the file.
std::string conversion_json(const Converted& made, const TableForm& form, const std::string& path,
                            const std::vector<std::string>& losses);

}  // namespace jounce
