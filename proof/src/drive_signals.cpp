// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/drive_signals.hpp"

#include <numbers>
#include <vector>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/detail/npy.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

struct Column {
  std::string name;
  std::string unit;
  std::vector<double> values = {};
};

std::vector<Column> columns_of(const DriveResult& run, const Input& input) {
  const Drive& drive = input.drive->drive;
  const std::string& u = input.labels.units.position;
  const double per_radian = drive.position_per_rev / (2 * std::numbers::pi);
  std::vector<Column> all{{"time", "s"},
                          {"command", u},
                          {"feedback", u},
                          {"load", u},
                          {"velocity", rate_unit(u, "s", 1)},
                          {"following_error", u},
                          {"torque", "N m"}};
  const double constant = drive.motor.torque_constant;
  if (constant > 0) all.push_back({"current", "A"});
  for (const DriveSample& s : run.samples) {
    const double row[] = {s.time,
                          s.reference,
                          s.motor,
                          s.load,
                          s.velocity * per_radian,
                          s.following_error + 0.0,
                          s.torque,
                          constant > 0 ? s.torque / constant : 0};
    for (std::size_t i = 0; i < all.size(); ++i) all[i].values.push_back(row[i]);
  }
  return all;
}

std::string signals_csv(const std::vector<Column>& columns, const Input& input) {
  std::string text = "# jounce drive signals 1\n# spec: " + printable(input.name) +
                     "\n# made by: " + made_by() + "\n";
  for (const Column& c : columns)
    text += (&c == &columns.front() ? "" : ",") + c.name + " [" + c.unit + "]";
  for (std::size_t i = 0; i < columns.front().values.size(); ++i) {
    text += '\n';
    for (const Column& c : columns)
      text += (&c == &columns.front() ? "" : ",") + number(c.values[i]);
  }
  return text + '\n';
}

std::string npy_of(const std::vector<Column>& columns) {
  std::vector<NpyField> fields;
  for (const Column& c : columns) fields.push_back({c.name});
  const std::size_t rows = columns.front().values.size();
  NpyFile file(fields, rows);
  for (std::size_t i = 0; i < rows; ++i)
    for (const Column& c : columns) file.add(c.values[i]);
  return file.bytes();
}

}  // namespace

std::string signals_file(const DriveResult& run, const Input& input, const std::string& path) {
  const std::vector<Column> columns = columns_of(run, input);
  return path.ends_with(".npy") ? npy_of(columns) : signals_csv(columns, input);
}

void require_signals(const std::string& key, const std::string& path) {
  if (path != "-" && !path.ends_with(".csv") && !path.ends_with(".npy"))
    throw InputError(key, path, "must end in .csv or .npy, or be - for CSV on standard output");
}

}  // namespace jounce
