// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <optional>
#include <string>

#include "jounce/base/detail/csv.hpp"
#include "jounce/base/units.hpp"
#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// A PVT sequence of Zaber's Motion Library as CSV: the time since the row before, and the absolute
// position and the velocity of each axis. The header names the columns, with units in parentheses.
namespace jounce::controllers_detail {
namespace {

/// A column: what it holds, its axis and its unit.
struct ZaberColumn {
  char kind = ' ';   ///< 't', 'p' or 'v'
  std::string axis;  ///< "axis 1"; "" for the time
  std::string unit;
};

ZaberColumn column_of(std::string_view cell, const Line& line, const Place& place) {
  const auto open = cell.find('('), close = cell.rfind(')');
  if (open == cell.npos || close == cell.npos || close < open)
    place.fail(line.number, "header", cell, "must have a unit in parentheses");
  const std::string words = lower(trimmed(cell.substr(0, open)));
  ZaberColumn column{' ', "", std::string(trimmed(cell.substr(open + 1, close - open - 1)))};
  if (!is_unit(column.unit)) place.fail(line.number, "header", column.unit, "is not a unit");
  for (const auto& [word, kind] : {std::pair{"time", 't'}, {"position", 'p'}, {"velocity", 'v'}})
    if (const auto at = words.find(word); at != words.npos) {
      column.kind = kind;
      column.axis = std::string(trimmed(std::string_view(words).substr(0, at)));
      return column;
    }
  place.fail(line.number, "header", cell, "must be a Time, Position or Velocity");
}

/// The columns of an axis, by their places in a row.
struct ZaberAxis {
  std::string name;
  std::size_t position = 0;
  std::optional<std::size_t> velocity = {};
  std::string unit;           ///< unit of its position
  double velocity_scale = 1;  ///< to this unit per second
};

class Sequence {
 public:
  Sequence(const Line& header, const Place& place) : place_(place) {
    std::size_t times = 0;
    const auto cells = csv_cells(header.text);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const ZaberColumn column = column_of(trimmed(cells[i]), header, place);
      columns_.push_back(column);
      if (column.kind == 't') time_ = i, ++times;
      if (column.kind == 'p') axes_.push_back({column.axis, i, {}, column.unit, 1});
    }
    if (times != 1) place.fail(header.number, "header", "", "must have one column Time");
    for (ZaberAxis& axis : axes_) find_velocity(axis, header);
    if (axes_.empty()) place.fail(header.number, "header", "", "must have a column Position");
    time_scale_ = scale(columns_[time_].unit, "s", header);
  }

  void row(const Line& line) {
    const auto cells = csv_cells(line.text);
    if (cells.size() != columns_.size())
      place_.fail(line.number, "row", std::to_string(cells.size()) + " values",
                  "must have " + std::to_string(columns_.size()) + ", as the header");
    const double dt = time_scale_ * place_.number(line.number, "Time", trimmed(cells[time_]));
    if (!(dt > 0) && !(read_.empty() && dt == 0))
      place_.fail(line.number, "Time", number(dt),
                  "must be greater than 0: it counts from the row before");
    x_ += dt;
    if (read_.empty()) begin();
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      Columns& to = read_[i].columns;
      to.x.push_back(x_);
      to.p.push_back(cell(line, cells, axes_[i].position, "Position"));
      to.v.push_back(axes_[i].velocity_scale * cell(line, cells, *axes_[i].velocity, "Velocity"));
      read_[i].lines.push_back(line.number);
    }
  }

  std::vector<Exchanged> finish() {
    if (read_.empty()) place_.fail(1, "", "", "has no rows: is the file complete?");
    return std::move(read_);
  }

 private:
  double scale(const std::string& unit, const std::string& to, const Line& header) const {
    if (!is_convertible(unit, to))
      place_.fail(header.number, "header", unit, "does not convert to " + to);
    return conversion(unit, to);
  }

  void find_velocity(ZaberAxis& axis, const Line& header) {
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].kind == 'v' && columns_[i].axis == axis.name) {
        axis.velocity = i;
        axis.velocity_scale = scale(columns_[i].unit, axis.unit + "/s", header);
      }
    if (!axis.velocity)
      place_.fail(header.number, "header", axis.name,
                  "has no velocities: Zaber's library computes them, Jounce does not. Let the "
                  "library generate and save them");
  }

  void begin() {
    for (const ZaberAxis& axis : axes_)
      read_.push_back(
          {.name = axis.name, .rule = Interpolation::cubic_hermite, .units = {"s", axis.unit}});
  }

  double cell(const Line& line, const std::vector<std::string_view>& cells, std::size_t i,
              const char* key) const {
    const std::string_view text = trimmed(cells[i]);
    if (text.empty())
      place_.fail(line.number, key, "", "is empty: Zaber's library computes it, Jounce does not");
    return place_.number(line.number, key, text);
  }

  const Place& place_;
  std::vector<ZaberColumn> columns_ = {};
  std::vector<ZaberAxis> axes_ = {};
  std::size_t time_ = 0;
  double time_scale_ = 1;
  double x_ = 0;
  std::vector<Exchanged> read_ = {};
};

std::vector<Exchanged> read_zaber(const std::string& text, const Place& place) {
  const auto lines = lines_of(text);
  Sequence sequence(lines.front(), place);
  for (std::size_t i = 1; i < lines.size(); ++i) sequence.row(lines[i]);
  return sequence.finish();
}

std::string zaber_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  const std::string& unit = file.units.position;
  std::string text = "Time (s),Axis 1 Position (" + unit + "),Axis 1 Velocity (" + unit + "/s)\n";
  double x = 0;
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    const double dx = increment(x, c.x[i] - c.x[0]);
    text += number(dx) + "," + number(c.p[i]) + "," + number(c.v[i]) + "\n";
    x += dx;
  }
  return text;
}

}  // namespace

constinit const FormatRow zaber_format{
    .format = {.name = "zaber",
               .maker = "Zaber Motion Library, PVT sequence as CSV",
               .knot = "a line `duration,position,velocity`, after a header with the units",
               .source = "Zaber, examples of PVT sequences: motion_pvt_sequence_generation",
               .extension = "",
               .join = KnotJoin::cubic,
               .axis = Domain::time,
               .x_unit = "s",
               .position_units = "mm cm",
               .keeps_units = true,
               .not_kept = "the times count from the start of the table"},
    .detects =
        [](const std::string& text) {
          const std::string head = lower(text.substr(0, text.find('\n')));
          return head.find("time (") != head.npos && head.find("axis") != head.npos &&
                 head.find("position (") != head.npos;
        },
    .read = read_zaber,
    .write = zaber_text};

}  // namespace jounce::controllers_detail
