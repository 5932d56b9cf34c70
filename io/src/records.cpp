// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/detail/records.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "jounce/base/detail/listed.hpp"
#include "jounce/path/arc.hpp"
#include "jounce/path/rotary.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

std::string column_of(std::string axis) {
  for (char& c : axis) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return axis + "_endpos";
}

class Records {
 public:
  Records(const Points& records, const GcodeMachine& machine, const RecordUnits& units)
      : records_(records), machine_(machine), units_(units) {
    require_columns();
    for (const GcodeMachine::Axis& axis : machine.axes)
      ends_.push_back(records.in_unit(column_of(axis.name), axis.unit));
    types_ = column("datatype", "");
    numbers_ = column("linenum", "");
    velocities_ = column("vel", units.velocity);
    accelerations_ = column("acc", units.acceleration);
    for (const char* name : {"aux_pos0", "aux_pos1"})
      via_.push_back(column(name, machine.axes.front().unit));
  }

  Program program() const {
    Program made(machine_.axes.size(), machine_.start, machine_.path_axes);
    for (std::size_t k = 0; k < records_.size(); ++k) add(k, made);
    return made;
  }

 private:
  [[noreturn]] void fail(std::size_t k, const std::string& key, double value,
                         const std::string& rule, const std::string& unit = "") const {
    throw records_.error(k, key, value, unit, rule);
  }

  void require_columns() const {
    std::vector<std::string> known{"linenum", "datatype", "vel", "acc", "aux_pos0", "aux_pos1"};
    for (const GcodeMachine::Axis& axis : machine_.axes) known.push_back(column_of(axis.name));
    for (const PointColumn& each : records_.columns) {
      if (std::find(known.begin(), known.end(), each.name) != known.end()) continue;
      throw InputError(each.name, "",
                       "is not a column of records; possible columns: " + listed(known))
          .at(records_.document, 1);
    }
  }

  /// Empty without the column.
  [[nodiscard]] std::vector<double> column(const char* name, const std::string& unit) const {
    return records_.find(name) != nullptr ? records_.in_unit(name, unit) : std::vector<double>{};
  }

  /// A number > 0 of a column; `otherwise` without it.
  [[nodiscard]] double positive(const std::vector<double>& values, std::size_t k, const char* key,
                                const std::string& unit, double otherwise) const {
    if (values.empty()) return otherwise;
    if (!(values[k] > 0)) fail(k, key, values[k], "must be greater than 0", unit);
    return values[k];
  }

  void add(std::size_t k, Program& made) const {
    if (!numbers_.empty() && (numbers_[k] < 0 || numbers_[k] != std::floor(numbers_[k])))
      fail(k, "linenum", numbers_[k], "must be a whole number of at least 0");
    PathSettings settings = machine_.settings;
    settings.velocity = positive(velocities_, k, "vel", units_.velocity, settings.velocity);
    settings.acceleration =
        positive(accelerations_, k, "acc", units_.acceleration, settings.acceleration);
    if (!accelerations_.empty()) settings.deceleration = settings.acceleration;
    made.set(settings);
    const int line = static_cast<int>(records_.lines[k]);
    Point to{};
    for (std::size_t i = 0; i < ends_.size(); ++i)
      to[i] = shortest_way(made.position()[i], ends_[i][k], machine_.axes[i].modulo);
    const double type = types_.empty() ? 1 : types_[k];
    if (type == 1) return made.line(to, line);
    if (type != 2) fail(k, "datatype", type, "must be 1, a line, or 2, an arc through Aux_Pos");
    try {
      made.arc(arc(k, made.position(), to), line);
    } catch (const InputError& error) {
      if (!error.document().empty()) throw;
      throw InputError("aux_pos0", error.value(), error.rule()).at(records_.document, line);
    }
  }

  [[nodiscard]] Arc arc(std::size_t k, const Point& from, const Point& to) const {
    if (via_[0].empty() || via_[1].empty())
      fail(k, via_[0].empty() ? "aux_pos0" : "aux_pos1", 2,
           "is missing: an arc needs both coordinates of its Aux_Pos");
    if (machine_.path_axes == 1 || machine_.axes.size() < 2)
      fail(k, "datatype", 2, "needs two axes that are not followers");
    Arc made = arc_through({from[0], from[1]}, {via_[0][k], via_[1][k]}, {to[0], to[1]}, 2);
    for (std::size_t i = 2; i < max_axes; ++i) {
      made.center[i] = from[i];
      made.drift[i] = to[i] - from[i];
    }
    made.to = to;
    return made;
  }

  const Points& records_;
  const GcodeMachine& machine_;
  const RecordUnits& units_;
  std::vector<std::vector<double>> ends_, via_;
  std::vector<double> types_, numbers_, velocities_, accelerations_;
};

}  // namespace

Program record_program(const Points& records, const GcodeMachine& machine,
                       const RecordUnits& units) {
  return Records(records, machine, units).program();
}

}  // namespace jounce
