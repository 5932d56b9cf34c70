// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/machine_master.hpp"

#include <array>
#include <filesystem>
#include <string>

#include "jounce/base/units.hpp"

#include "spec/src/axis_drive.hpp"
#include "spec/src/toml/parts.hpp"

namespace jounce::spec_detail {
namespace {

const std::array<std::string, 3> master_kinds{"external", "encoder", "table"};

void may(TomlReader& reader, const char* key, const std::string& unit, double& value) {
  value = reader.optional_number(key, unit).value_or(value);
  if (value < 0) reader.fail(key, number(value), "must not be negative");
}

double positive_number(TomlReader& reader, const char* key, const std::string& unit) {
  const double value = reader.number(key, unit);
  if (!(value > 0)) reader.fail(key, number(value), "must be greater than 0");
  return value;
}

/// A time of the filter, at most a minute: a master that moves an axis is measured many times a
/// second, and a longer time would stop the axis too late.
constexpr double longest = 60;

void may_last(TomlReader& reader, const char* key, double& seconds) {
  seconds = reader.optional_number(key, "s").value_or(seconds);
  if (!(seconds <= longest))
    reader.fail(key, number(seconds), "must be at most " + number(longest) + " s");
}

void must_last(TomlReader& reader, const char* key, double& seconds) {
  may_last(reader, key, seconds);
  if (!(seconds > 0)) reader.fail(key, number(seconds), "must be greater than 0");
}

TrackingSpec read_tracking(TomlReader& reader, const std::string& unit) {
  TrackingSpec tracking;
  tracking.velocity = positive_number(reader, "velocity", rate_unit(unit, "s", 1));
  tracking.acceleration = positive_number(reader, "acceleration", rate_unit(unit, "s", 2));
  if (const auto order = reader.optional_count("order")) {
    if (*order != 2 && *order != 3) reader.fail("order", std::to_string(*order), "must be 2 or 3");
    tracking.order = static_cast<int>(*order);
  }
  must_last(reader, "time_constant", tracking.time_constant);
  must_last(reader, "settle", tracking.settle);
  must_last(reader, "longest_age", tracking.longest_age);
  may_last(reader, "latency", tracking.latency);
  if (tracking.latency < 0)
    reader.fail("latency", number(tracking.latency), "must not be negative");
  may(reader, "jump", unit, tracking.jump);
  may(reader, "modulo", unit, tracking.modulo);
  return tracking;
}

MachineMasterSpec::Encoder read_encoder(TomlReader& reader, const std::string& unit) {
  MachineMasterSpec::Encoder encoder{.tracking = read_tracking(reader, unit)};
  if (reader.has("axis") == reader.has("drive"))
    reader.fail(
        "axis", "",
        reader.has("axis")
            ? "cannot be combined with drive: give only the one that has the encoder"
            : "is missing: add axis = \"NAME\", or [drive] of the master, whichever has the "
              "encoder");
  if (reader.has("axis")) encoder.axis = reader.text("axis");
  if (auto drive = reader.optional_table("drive")) {
    encoder.drive = read_shared(*drive, {.x = "s", .position = unit});
    drive->finish();
  }
  may(reader, "resolution", unit, encoder.resolution);
  may(reader, "noise", unit, encoder.noise);
  encoder.seed = reader.optional_count("seed").value_or(1);
  return encoder;
}

MachineMasterSpec::FromTable read_from_table(TomlReader& reader, const std::string& unit) {
  MachineMasterSpec::FromTable table{.file = reader.text("file", "FILE")};
  const auto folder = std::filesystem::path(reader.document().name).parent_path();
  if (const std::filesystem::path given(table.file); given.is_relative())
    table.file = (folder / given).string();
  table.limits.velocity = positive_number(reader, "velocity", rate_unit(unit, "s", 1));
  table.limits.acceleration = positive_number(reader, "acceleration", rate_unit(unit, "s", 2));
  if (reader.has("jerk"))
    table.limits.jerk = positive_number(reader, "jerk", rate_unit(unit, "s", 3));
  return table;
}

MachineMasterSpec read_master(TomlReader& reader, const std::string& name) {
  MachineMasterSpec master{.name = name, .unit = {}, .what = MachineMasterSpec::External{}};
  master.key = reader.path("kind");
  master.key.erase(master.key.rfind('.'));
  const std::size_t kind = reader.choice("kind", master_kinds);
  master.unit = read_master_unit(reader, "unit");
  if (kind == 0)
    master.what = MachineMasterSpec::External{read_tracking(reader, master.unit)};
  else if (kind == 1)
    master.what = read_encoder(reader, master.unit);
  else
    master.what = read_from_table(reader, master.unit);
  reader.finish();
  return master;
}

bool is_name(const std::string& name) {
  constexpr const char* letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
  return !name.empty() && name.size() <= 23 && name.find_first_not_of(letters) == std::string::npos;
}

}  // namespace

std::vector<MachineMasterSpec> read_masters(TomlReader& top) {
  std::vector<MachineMasterSpec> masters;
  auto all = top.optional_table("master");
  if (!all) return masters;
  bool whole = true;
  const auto read = [&](const std::string& name) {
    if (!is_name(name))
      all->fail(name.c_str(), name,
                "must have 1 to 23 characters, each a letter A-Z or a-z, a digit, _ or -");
    if (!all->is_table(name.c_str()))
      all->fail(name.c_str(), "", "is not a master: begin a section [master.NAME] for each master");
    TomlReader reader = all->table(name.c_str());
    masters.push_back(read_master(reader, name));
  };
  for (const std::string& name : all->keys()) whole = all->attempt([&] { read(name); }) && whole;
  if (!whole) throw PartEnded{};
  all->finish();
  return masters;
}

}  // namespace jounce::spec_detail
