// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "jounce/design/input.hpp"
#include "jounce/spec/detail/text_numbers.hpp"

#include "edit/src/json_reader.hpp"

/// The changes of a text that a reader can make without typing it. All kinds of specs have the same two
/// forms: *handles*, places in a picture that the mouse moves, and *tables* of numbers for the keyboard.
/// Each of them contains the change that it makes. docs/reference/http.md describes their JSON.
namespace jounce::edit_detail {

/// The change that sets numbers by their keys.
inline Json numbers_change() {
  return Json::object({{"do", "numbers"}});
}

/// A list of tables of the text ("knot") with one point in each table.
struct PointList {
  std::string list;                     ///< key of the list
  std::string title;                    ///< "Knots"
  std::string one;                      ///< "knot"
  std::vector<std::string> columns;     ///< keys of the numbers of a point
  std::vector<std::string> heads = {};  ///< names of the columns; empty: their keys
};

/// A spec, its motion, and what can be changed in it.
class Editable {
 public:
  /// `axes`: the motion of each axis; empty if the text describes no motion.
  Editable(const Spec& spec, const std::vector<Input>& axes);

  [[nodiscard]] const Spec& spec() const { return spec_; }
  /// Curves of all axes; empty if the text describes no motion.
  [[nodiscard]] const std::vector<const LazyCurve::Any*>& curves() const { return curves_; }

  /// The number with this key; null: the text does not have it.
  [[nodiscard]] const TextNumber* find(const std::string& key) const;
  /// True if the text has the number, or can have it.
  [[nodiscard]] bool can_have(const std::string& key) const;
  /// Number of tables in a list of the text.
  [[nodiscard]] std::size_t count(const std::string& list) const;
  /// Line of a key in the text; 0: unknown.
  [[nodiscard]] int line(const std::string& key) const;

  /// A coordinate of a handle that changes the number `key` by as much as the handle moves. Place and
  /// key are null if they are not given: the handle is then on the curve, or does not move.
  [[nodiscard]] Json coordinate(const std::optional<double>& place, const std::string& key) const;
  /// A coordinate that does not move.
  static Json fixed(double place);

  /// Adds a handle in the picture of an axis. `order`: order of the derivative of its panel. Returns
  /// the handle, for more members. No handle is added to a text without a motion.
  Json& add_handle(const std::string& label, std::size_t axis, std::size_t order, Json x, Json y,
                   Json change = numbers_change());
  /// Adds a handle in the plane of several axes, with one coordinate for each axis.
  Json& add_plane_handle(const std::string& label, Json at);
  /// Adds a table with a row for each point of a list.
  void add_points(const PointList& points);
  void add_table(Json table) { tables_.push_back(std::move(table)); }
  /// Marks numbers that need no row in the table of all other numbers.
  void hide(const std::string& begin) { hidden_.push_back(begin); }
  /// Permits points to be inserted at a position of the axis x, or in the plane.
  void permit_insert() { insert_ = true; }
  void permit_plane_insert() { plane_insert_ = true; }

  /// The handles and tables, with a table of all numbers that have no row yet.
  [[nodiscard]] std::string json();

 private:
  void add_other_numbers();

  const Spec& spec_;
  std::vector<const LazyCurve::Any*> curves_;
  std::vector<TextNumber> numbers_;
  std::map<std::string, std::size_t> index_;
  std::set<std::string> shown_;
  std::vector<std::string> hidden_;
  Json handles_ = Json::array();
  Json plane_ = Json::array();
  Json tables_ = Json::array();
  bool insert_ = false;
  bool plane_insert_ = false;
};

/// Returns the handles and tables of a spec as JSON. `axes`: the motion of each axis; empty if the
/// text describes no motion.
std::string editable_json(const Spec& spec, const std::vector<Input>& axes);

}  // namespace jounce::edit_detail
