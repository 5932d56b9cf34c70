// SPDX-License-Identifier: Apache-2.0
#include "spec/src/axis_drive.hpp"

#include <array>
#include <filesystem>
#include <string>

namespace jounce::spec_detail {
namespace {

const std::array<std::string, 3> drive_types{"null", "simulated", "shared_memory"};

/// Reads the model from another file, of kind "drive".
Drive read_model_file(TomlReader& table, const Units& units) {
  const std::filesystem::path given(table.text("spec", "FILE.toml"));
  const auto folder = std::filesystem::path(table.document().name).parent_path();
  const std::string path = (given.is_relative() ? folder / given : given).string();
  const Spec spec = table.file_of("spec", path, [&] { return read_spec(path); });
  if (!std::holds_alternative<DriveAlone>(spec.subject))
    table.fail("spec", given.string(), "must be a spec of kind \"drive\": see `jounce new drive`");
  if (spec.units.position != units.position)
    table.fail("spec", given.string(),
               "has the unit " + spec.units.position + ", but this axis has " + units.position +
                   ": use the same unit in both");
  return spec.drive->drive;
}

}  // namespace

AxisDriveSpec::Shared read_shared(TomlReader& table, const Units& units) {
  AxisDriveSpec::Shared shared{.name = table.text("name")};
  shared.increments_per_rev = table.number("increments_per_rev", "1");
  shared.position_per_rev = table.number("position_per_rev", units.position + "/rev");
  shared.reversed = table.optional_flag("reversed").value_or(false);
  shared.window = table.optional_number("window", units.position).value_or(0);
  const auto cycles = table.optional_count("silent_cycles").value_or(50);
  if (cycles < 1 || cycles > 1'000'000)
    table.fail("silent_cycles", std::to_string(cycles), "must be from 1 to 1e6");
  shared.silent_cycles = static_cast<int>(cycles);
  return shared;
}

std::optional<AxisDriveSpec> read_axis_drive(TomlReader& top, const Units& units,
                                             const std::string& master_unit) {
  auto table = top.optional_table("drive");
  if (!table) return std::nullopt;
  AxisDriveSpec drive;
  drive.type =
      static_cast<AxisDriveSpec::Type>(table->optional_choice("type", drive_types).value_or(1));
  if (drive.type != AxisDriveSpec::Type::shared_memory)
    drive.machine = read_machine_sensors(*table, units, master_unit);
  if (drive.type == AxisDriveSpec::Type::simulated && !table->has("spec")) {
    drive.model = read_drive_table(*table, units).drive;
    return drive;
  }
  if (drive.type == AxisDriveSpec::Type::simulated) drive.model = read_model_file(*table, units);
  if (drive.type == AxisDriveSpec::Type::shared_memory) {
    drive.shared = read_shared(*table, units);
    const auto probes = table->optional_count("touch_probes").value_or(0);
    if (probes > 2) table->fail("touch_probes", std::to_string(probes), "must be 0, 1 or 2");
    drive.shared->touch_probes = static_cast<int>(probes);
  }
  table->finish();
  return drive;
}

}  // namespace jounce::spec_detail

namespace jounce {

std::optional<AxisDriveSpec> axis_drive(const Spec& spec) {
  Document document = spec.document;
  const toml::table root = spec_detail::parse_toml(document);
  spec_detail::TomlReader top(root, "", document);
  try {
    return spec_detail::read_axis_drive(top, spec.units, spec.master_unit);
  } catch (const InputError& error) {
    throw document.located(error);
  }
}

}  // namespace jounce
