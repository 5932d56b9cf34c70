// SPDX-License-Identifier: Apache-2.0
#include "spec/src/cams/shape_figures.hpp"

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/detail/nearest.hpp"
#include "jounce/base/units.hpp"
#include "jounce/spec/detail/drive_figures.hpp"

namespace jounce {

double shown(const ShapeFigureSpec& figure, double value, double length) {
  return figure.factor * value * (figure.squared ? value : 1) * (figure.times_length ? length : 1);
}

double computed(const ShapeFigureSpec& figure, double shown) {
  const double value = shown / figure.factor;
  return figure.squared ? std::sqrt(value) : value;
}

namespace spec_detail {
namespace {

const std::array<std::string, 5> over_master{"slave", "geo_velocity", "geo_acceleration",
                                             "geo_jerk", "geo_jounce"};
const std::array<std::string, 5> over_time{"position", "velocity", "acceleration", "jerk",
                                           "jounce"};

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const char* how : {"peak ", "rms "}) {
    for (std::size_t k = 1; k < over_master.size(); ++k) names.push_back(how + over_master[k]);
    for (std::size_t k = 1; k < over_time.size(); ++k) names.push_back(how + over_time[k]);
    names.push_back(how + std::string("torque"));
  }
  for (const char* name : {"peak power", "motor heating", "energy", "driving energy", "residual"})
    names.emplace_back(name);
  for (const DriveFigure figure : all_drive_figures) names.push_back(jounce::name(figure));
  return names;
}

[[noreturn]] void fail_name(TomlReader& reader, const char* key, const std::string& name,
                            std::span<const std::string> known) {
  const std::string hint = nearest(name, known);
  reader.fail(key, '"' + name + '"',
              std::string("must be one of ") + listed(known) +
                  (hint.empty() ? "" : ": did you mean \"" + hint + "\"?"));
}

double speed_for(TomlReader& reader, const char* key, const std::string& name,
                 const ShapeWords& words) {
  if (!words.speed)
    reader.fail(key, '"' + name + '"', "needs the speed of the master: add [master] with velocity");
  return *words.speed;
}

const LoadSpec& load_for(TomlReader& reader, const char* key, const std::string& name,
                         const ShapeWords& words) {
  if (words.load == nullptr)
    reader.fail(key, '"' + name + '"',
                "needs the load: add [load] with position_per_rev and inertia");
  return *words.load;
}

const LoadSpec& linear_load_for(TomlReader& reader, const char* key, const std::string& name,
                                const ShapeWords& words) {
  const LoadSpec& load = load_for(reader, key, name, words);
  if (!is_linear(load))
    reader.fail(key, '"' + name + '"',
                "is not possible with coulomb or lever in [load]: use \"peak torque\" instead");
  return load;
}

LinearQuantity derivative(const std::string& name, std::size_t order, double factor) {
  LinearQuantity quantity{name, {}, 0};
  quantity.by[order] = factor;
  return quantity;
}

std::optional<std::size_t> index_of(const std::array<std::string, 5>& names,
                                    const std::string& name) {
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return k;
  return std::nullopt;
}

/// The quantity called `name`, which is a part of the spec's text `said`.
std::optional<NamedQuantity> found(TomlReader& reader, const char* key, const std::string& name,
                                   const std::string& said, const ShapeWords& words) {
  const auto rate = [&](const std::string& x, std::size_t k) {
    return rate_unit(words.units.position, x, static_cast<int>(k));
  };
  if (const auto k = index_of(over_master, name))
    return NamedQuantity{derivative(name, *k, 1), rate(words.units.x, *k)};
  if (const auto k = index_of(over_time, name); k && *k > 0) {
    const double speed = speed_for(reader, key, said, words);
    return NamedQuantity{derivative(name, *k, std::pow(speed, static_cast<double>(*k))),
                         rate(words.time_unit, *k)};
  }
  if (name == "torque") {
    const double speed = speed_for(reader, key, said, words) / words.seconds;
    const LoadSpec& load = linear_load_for(reader, key, said, words);
    return NamedQuantity{torque_of(load, speed, words.units.position), "N m"};
  }
  return std::nullopt;
}

ShapeFigureSpec power_named(TomlReader& reader, const char* key, const std::string& name,
                            const ShapeWords& words) {
  const double speed = speed_for(reader, key, name, words) / words.seconds;
  const LoadSpec& load = linear_load_for(reader, key, name, words);
  const LinearQuantity torque = torque_of(load, speed, words.units.position);
  return {name, "W", PowerOf{torque, motor_speed_of(load, speed)}};
}

/// The torque of a load that is not linear.
std::optional<ShapeFigureSpec> load_named(TomlReader& reader, const char* key,
                                          const std::string& name, const ShapeWords& words) {
  const bool energy = name == "driving energy";
  if (!energy && name != "peak torque" && name != "rms torque") return std::nullopt;
  const double speed = speed_for(reader, key, name, words) / words.seconds;
  const LoadSpec& load = load_for(reader, key, name, words);
  if (energy) return ShapeFigureSpec{name, "J", energy_of(load, speed, words.units.position)};
  if (is_linear(load)) return std::nullopt;
  const LoadTorque torque = load_torque_of(load, speed, words.units.position);
  if (name == "peak torque") return ShapeFigureSpec{name, "N m", TorqueOf{torque}};
  return ShapeFigureSpec{name, "N m", RmsTorqueOf{torque}};
}

ShapeFigure rms_torque_of(const LoadSpec& load, double speed, const std::string& unit) {
  if (is_linear(load)) return RmsOf{torque_of(load, speed, unit)};
  return RmsTorqueOf{load_torque_of(load, speed, unit)};
}

ShapeFigureSpec loss_named(TomlReader& reader, const char* key, const std::string& name,
                           const ShapeWords& words) {
  const double speed = speed_for(reader, key, name, words) / words.seconds;
  const LoadSpec& load = load_for(reader, key, name, words);
  if (!load.winding_loss)
    reader.fail(key, '"' + name + '"',
                "needs load.winding_loss: the motor's resistance / (torque constant)^2");
  ShapeFigureSpec figure{name, "W", rms_torque_of(load, speed, words.units.position),
                         *load.winding_loss, true};
  if (name == "motor heating") return figure;
  figure.unit = "J";
  figure.factor /= speed;
  figure.times_length = true;
  return figure;
}

/// A figure of a drive; the drive is not known yet.
ShapeFigureSpec driven(TomlReader& reader, const char* key, DriveFigure figure,
                       const ShapeWords& words) {
  speed_for(reader, key, name(figure), words);
  const bool torque = figure == DriveFigure::torque || figure == DriveFigure::rms_torque;
  return {name(figure), torque ? "N m" : words.units.position, asked(figure)};
}

}  // namespace

NamedQuantity quantity_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words) {
  if (auto quantity = found(reader, key, name, name, words)) return *quantity;
  std::vector<std::string> known(over_master.begin(), over_master.end());
  known.insert(known.end(), over_time.begin() + 1, over_time.end());
  known.emplace_back("torque");
  fail_name(reader, key, name, known);
}

ShapeFigureSpec figure_named(TomlReader& reader, const char* key, const std::string& name,
                             const ShapeWords& words) {
  if (name == "residual")
    reader.fail(key, "\"residual\"",
                "needs a frequency: [[optimize.minimize]] with figure = \"residual\" and at = "
                "\"17 Hz\"");
  if (name == "peak power") return power_named(reader, key, name, words);
  if (name == "motor heating" || name == "energy") return loss_named(reader, key, name, words);
  if (auto of_load = load_named(reader, key, name, words)) return *of_load;
  if (const auto drive = drive_figure(name)) return driven(reader, key, *drive, words);
  const bool peak = name.starts_with("peak ");
  const bool rms = name.starts_with("rms ");
  const std::string of = peak ? name.substr(5) : rms ? name.substr(4) : "";
  if (of != "slave" && !of.empty())
    if (auto quantity = found(reader, key, of, name, words)) {
      if (peak) return {name, quantity->unit, PeakOf{quantity->quantity}};
      return {name, quantity->unit, RmsOf{quantity->quantity}};
    }
  fail_name(reader, key, name, figure_names());
}

ShapeFigureSpec read_figure(TomlReader& table, const ShapeWords& words) {
  const std::string name = table.text("figure", "FIGURE");
  if (name != "residual") return figure_named(table, "figure", name, words);
  const double speed = speed_for(table, "figure", name, words) / words.seconds;
  const auto at = table.optional_range("at", "Hz");
  if (!at)
    table.fail("at", "", "is missing: give a frequency, such as \"17 Hz\", or a band of two");
  const auto damping = table.optional_range("damping", "1").value_or(std::pair{0., 0.});
  if (!(at->first > 0 && at->first <= at->second))
    table.fail("at", number(at->first),
               "must be greater than 0, and a band must be [lowest, highest]");
  if (!(damping.first >= 0 && damping.first <= damping.second && damping.second < 1))
    table.fail("damping", number(damping.first),
               "must be at least 0 and less than 1, and a range must be [lowest, highest]");
  const ResidualOf residual{at->first / speed, at->second / speed, damping.first, damping.second};
  const std::string shown = at->first == at->second
                                ? number(at->first) + " Hz"
                                : number(at->first) + " to " + number(at->second) + " Hz";
  return {"residual " + shown, words.units.position, residual};
}

}  // namespace spec_detail
}  // namespace jounce
