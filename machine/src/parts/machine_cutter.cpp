// SPDX-License-Identifier: Apache-2.0
#include "machine/src/parts/machine_cutter.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce::machine_detail {
namespace {

constexpr const char* cutter_key = "axis.cutter";

/// The smaller of two limits.
void lower(std::optional<double>& limit, const std::optional<double>& other) {
  if (other) limit = std::min(limit.value_or(*other), *other);
}

Spec read_cutter(const Spec& axis, const std::string& file) {
  const std::string path = cutter_path(axis, file);
  try {
    return read_spec(path);
  } catch (const InputError& error) {
    throw axis.document.naming(cutter_key, path, error);
  }
}

CutJob job_of(const Spec& cutter, const CutListSpec& list, const Limits& axis) {
  if (!cutter.master)
    throw InputError("master.velocity", "",
                     "is missing: add [master] with velocity, the greatest speed of the line");
  CutJob job{list, {.speed = cutter.master->velocity, .rates = {}, .slave = cutter.slave}};
  job.line.rates.acceleration = cutter.master->acceleration.value_or(0);
  lower(job.line.slave.velocity, axis.velocity);
  lower(job.line.slave.acceleration, axis.acceleration);
  lower(job.line.slave.jerk, axis.jerk);
  if (auto* shear = std::get_if<FlyingShear>(&job.spec.machine)) {
    shear->limits = job.line.slave;
    shear->line_speed = job.line.speed;
  }
  return job;
}

/// The error with the keys of the document. The velocity of [master] takes the place of line_speed.
InputError in_cutter(const InputError& error, const Document& document, bool shear) {
  const std::string speed = "line_speed";
  const std::string velocity = "master.velocity";
  const bool has_master = !shear || document.places.contains(velocity);
  std::string key = error.key();
  std::string rule = error.rule();
  for (std::size_t at = 0; has_master && (at = rule.find(speed, at)) != std::string::npos;)
    rule.replace(at, speed.size(), velocity);
  if (key == speed && has_master) key = velocity;
  const bool whole = key.starts_with("master.") || key.starts_with("limits.");
  return {whole ? key : (shear ? "shear." : "knife.") + key, error.value(), rule};
}

}  // namespace

std::string cutter_path(const Spec& axis, const std::string& file) {
  return (std::filesystem::path(axis.document.name).parent_path() / file).string();
}

std::optional<ExecutorCutter> machine_cutter(const Spec& axis, const AxisConfig& config) {
  const std::string& file = std::get<AxisSpec>(axis.subject).cutter;
  if (file.empty()) return std::nullopt;
  const Spec cutter = read_cutter(axis, file);
  const auto refuse = [&](const std::string& rule) {
    throw axis.document.located(InputError(cutter_key, '"' + file + '"', rule));
  };
  const auto* sync = std::get_if<SyncSpec>(&cutter.subject);
  const auto list = sync == nullptr ? std::nullopt : cut_list_of(*sync);
  if (!list) refuse("must be a spec of kind \"knife\" or \"shear\"");
  if (cutter.units.position != axis.units.position)
    refuse("has units.position = \"" + cutter.units.position + "\", but the axis has " +
           axis.units.position + ": use the same unit");
  if (cutter.units.x != axis.master_unit)
    refuse("has units.master = \"" + cutter.units.x + "\", but the axis has " +
           (axis.master_unit.empty() ? "none" : axis.master_unit) + ": use the same unit");
  if (cutter.time_unit != "s")
    refuse("has the time unit " + cutter.time_unit + ": use units.time = \"s\"");
  try {
    return executor_cutter(job_of(cutter, *list, config.limits),
                           {cutter.units.x, cutter.units.position});
  } catch (const InputError& error) {
    throw cutter.document.located(
        in_cutter(error, cutter.document, std::holds_alternative<FlyingShear>(list->machine)));
  }
}

}  // namespace jounce::machine_detail
