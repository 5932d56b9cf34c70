// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/check_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/design/certificate.hpp"
#include "jounce/cam/design/characteristics.hpp"
#include "jounce/design/detail/cam_check.hpp"
#include "jounce/design/detail/load_figures.hpp"
#include "jounce/design/detail/sync_check.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "design/src/check/master_check.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

constexpr double uneven_peaks = 1e-5;  ///< share of the peak acceleration

constexpr std::size_t most_rises = 8;

std::string rise_line(const Rise& rise, const Labels& labels) {
  const Characteristics c = characteristics(rise);
  const Report best = certificates(rise);
  const auto front = std::find_if(best.findings.begin(), best.findings.end(), [](const Finding& f) {
    return f.rule == "bound/acceleration_for_jerk";
  });
  const auto n = fmt::format("{} .. {} {}", rounded(rise.cam.start()), rounded(rise.cam.end()),
                             labels.units.x);
  const bool uneven = std::abs(c.ca.value - c.ca_star.value) > uneven_peaks * c.peak_acceleration();
  std::string line = fmt::format(
      "  {} {:<15} velocity Cv {:.5g}, acceleration Ca {:.5g}{}, jerk Cj {:.5g}, torque Cm {:.5g}",
      c.stroke < 0 ? "fall" : "rise", n, c.cv.value, c.ca.value,
      uneven ? fmt::format(", deceleration Ca* {:.5g}", c.ca_star.value) : "", c.cj.value,
      c.cm.value);
  if (front != best.findings.end())
    line += fmt::format("; with this Cj, Ca can be as low as {:.5g}", front->limit);
  return line + "\n";
}

std::string fastest_line(const Cam& cam, const Input& input) {
  const MasterRates rates = master_rates(*input.spec);
  if (rates.acceleration > 0 && master_accelerates_too_fast(cam, *input.spec)) {
    const MasterLimit most = greatest_master_acceleration(cam, *input.spec);
    const MasterSpeed both = fastest_master_with_ramp(cam, *input.spec);
    const SpeedUnit unit = master_speed_unit(*input.spec);
    const std::string slower =
        both.velocity < input.spec->master->velocity
            ? fmt::format(" at rest; the master may run at {} {} with {} {}",
                          six_digits_down(both.velocity / unit.size), unit.name,
                          six_digits_down(both.acceleration), master_rate_unit(*input.spec, 2))
            : "";
    return fmt::format(
        "  fastest acceleration of the master {} {}, limited by the slave's {} at {} {}{}\n",
        six_digits_down(most.value), master_rate_unit(*input.spec, 2), most.quantity,
        rounded(most.where), input.labels.units.x, slower);
  }
  const MasterLimit limit = greatest_master_velocity(cam, input.spec->slave, rates);
  if (std::isinf(limit.value)) return "";
  const SpeedUnit unit = master_speed_unit(*input.spec);
  std::string line =
      fmt::format("  fastest master {} {}", six_digits_down(limit.value / unit.size), unit.name);
  if (is_made_for_a_speed(*input.spec)) line += " for this table";
  if (rates.acceleration > 0)
    line += fmt::format(" while it accelerates with {} {}", rounded(rates.acceleration),
                        master_rate_unit(*input.spec, 2));
  return line + fmt::format(", limited by the slave's {} at {} {}{}\n", limit.quantity,
                            rounded(limit.where), input.labels.units.x,
                            input.spec->master ? ""
                                               : "; limits.slave is not checked, because the spec "
                                                 "has no [master]");
}

/// The figures of a synchronous slave, one line each.
std::string figure_lines(const Input& input) {
  std::string text;
  if (!input.spec) return text;
  for (const SyncFigure& f : sync_figures(*input.spec)) {
    const std::string value = rounded(f.value) + (f.unit.empty() ? "" : " " + f.unit);
    text +=
        fmt::format("  {:<20} {}{}\n", f.name, value, f.meaning.empty() ? "" : ": " + f.meaning);
  }
  return text;
}

/// "  load                 peak torque 0.5 N m at 94 deg, rms torque 0.2 N m"
std::string load_line(const Cam& cam, const Input& input) {
  if (!input.spec) return "";
  std::string text;
  for (const LoadFigure& f : load_figures(*input.spec, cam))
    text += (text.empty() ? "" : ", ") + f.name + " " + rounded(f.value) + " " + f.unit +
            (f.where ? " at " + rounded(*f.where) + " " + input.labels.units.x : "");
  return text.empty() ? "" : fmt::format("  {:<20} {}\n", "load", text);
}

Json load_json(const Cam& cam, const Input& input) {
  Json list = Json::array();
  if (!input.spec) return list;
  for (const LoadFigure& f : load_figures(*input.spec, cam))
    list.push_back({{"name", f.name},
                    {"value", f.value},
                    {"unit", f.unit},
                    {"where", f.where ? Json(*f.where) : Json()}});
  return list;
}

Json figures_json(const Input& input) {
  Json list = Json::array();
  if (!input.spec) return list;
  for (const SyncFigure& f : sync_figures(*input.spec))
    list.push_back(
        {{"name", f.name}, {"value", f.value}, {"unit", f.unit}, {"meaning", f.meaning}});
  return list;
}

Json json_of(const Coefficient& c) {
  return {{"value", std::isinf(c.value) ? Json() : Json(c.value)}, {"where", c.where}};
}

Json json_of(const MasterLimit& limit, const std::string& unit) {
  if (std::isinf(limit.value)) return nullptr;
  return {{"value", limit.value},
          {"unit", unit},
          {"limited_by", limit.quantity},
          {"where", limit.where}};
}

Json json_of(const Rise& rise) {
  const Characteristics c = characteristics(rise);
  return {{"from", rise.cam.start()},
          {"to", rise.cam.end()},
          {"stroke", c.stroke},
          {"segment", rise.first + 1},
          {"cv", json_of(c.cv)},
          {"ca", json_of(c.ca)},
          {"ca_star", json_of(c.ca_star)},
          {"cj", json_of(c.cj)},
          {"cj_inside", c.cj_inside},
          {"cm", json_of(c.cm)},
          {"rms", std::isinf(c.rms) ? Json() : Json(c.rms)}};
}

/// "track 1: on from 350 to 10 deg of the master, positive direction"
std::string text_of(const CamSwitch& s, const Spec& spec) {
  const bool of_master = spec.switches.of == SwitchesOf::master;
  const std::string unit = of_master ? spec.units.x + " of the master" : spec.units.position;
  const std::string first = number(s.first_on_position);
  const std::string where =
      s.last_on_position
          ? fmt::format("from {} to {} {}", first, number(*s.last_on_position), unit)
          : fmt::format("at {} {} for {} s", first, unit, number(s.duration.value_or(0)));
  const bool both = s.axis_direction == AxisDirection::both;
  return fmt::format("track {}: on {}{}", s.track, where,
                     both ? "" : fmt::format(", {} direction", name(s.axis_direction)));
}

std::string switches_text(const Spec& spec) {
  std::string text;
  for (const CamSwitch& s : spec.switches.table.switches) text += text_of(s, spec) + "\n";
  return text.empty() ? "" : "\n" + text;
}

/// For each rise, a line with its characteristic values and the fastest master; "" for a motion
/// over time.
std::string cam_text(const Input& input) {
  if (!input.labels.over_master) return "";
  const Cam& cam = std::get<Cam>(*input.curve);
  std::string text = figure_lines(input);
  const auto all = has_designed_rises(input) ? rises(cam) : std::vector<Rise>{};
  for (std::size_t i = 0; i < std::min(most_rises, all.size()); ++i)
    text += rise_line(all[i], input.labels);
  if (all.size() > most_rises)
    text += fmt::format("  ... and {}\n", counted(all.size() - most_rises, "more rise"));
  if (input.spec && has_slave_limits(*input.spec)) text += fastest_line(cam, input);
  return text + load_line(cam, input);
}

/// The same as JSON with all values; null for a motion over time.
Json cam_json(const Input& input) {
  if (!input.labels.over_master) return nullptr;
  const Cam& cam = std::get<Cam>(*input.curve);
  Json list = Json::array();
  for (const Rise& rise : rises(cam)) list.push_back(json_of(rise));
  Json document{{"rises", std::move(list)}};
  if (Json figures = figures_json(input); !figures.empty()) document["sync"] = std::move(figures);
  if (Json load = load_json(cam, input); !load.empty()) document["load"] = std::move(load);
  if (!input.spec || !has_slave_limits(*input.spec)) return document;
  const MasterLimit fastest =
      greatest_master_velocity(cam, input.spec->slave, master_rates(*input.spec));
  document["fastest_master"] = json_of(fastest, master_rate_unit(*input.spec, 1));
  if (input.spec->master)
    document["greatest_master_acceleration"] =
        json_of(greatest_master_acceleration(cam, input.spec->slave, input.spec->master->velocity),
                master_rate_unit(*input.spec, 2));
  return document;
}

}  // namespace

std::string check_text(const Report& report, const Input& input) {
  std::string extrema;
  if (!input.plan)  // the summary of a path already has these lines
    extrema =
        of_motion(input, [&](const auto& motion) { return extrema_text(motion, input.labels); }) +
        "\n";
  return fmt::format("{}: {}\n\n", input.name, one_line(report, input.labels)) + extrema +
         full_text(report, input.labels) + cam_text(input) +
         (input.spec ? switches_text(*input.spec) : "");
}

std::string check_json(const Report& report, const Input& input) {
  Json document = Json::parse(to_json(report, input.labels));
  if (Json cam = cam_json(input); !cam.is_null()) document["cam"] = std::move(cam);
  document["segments"] = Json::parse(
      of_motion(input, [&](const auto& motion) { return extrema_json(motion, input.labels); }));
  if (input.spec)
    for (const CamSwitch& s : input.spec->switches.table.switches)
      document["switches"].push_back(text_of(s, *input.spec));
  return document.dump();
}

}  // namespace jounce
