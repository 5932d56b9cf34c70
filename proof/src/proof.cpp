// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/proof.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/design/detail/driven.hpp"
#include "jounce/design/detail/reference.hpp"
#include "jounce/spec/sync_spec.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "proof/src/figure/follower_figure.hpp"
#include "proof/src/robustness.hpp"
#include "proof/src/text/drive_text.hpp"
#include "proof/src/text/follower_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

/// Adds the findings of one part, with their units.
void add_part(Report& all, const Report& part, const char* axis,
              const std::string& where_unit = "") {
  for (Finding finding : part.findings) {
    finding.axis = axis;
    if (finding.where_unit.empty()) finding.where_unit = where_unit;
    if (finding.rule.family() == RuleFamily::witness) finding.unit = "of the range";
    all.findings.push_back(std::move(finding));
  }
}

/// Gives the unit of the position to findings without a unit.
void in_position_unit(Report& report, const std::string& unit) {
  for (Finding& finding : report.findings)
    if (finding.unit.empty()) finding.unit = unit;
}

/// The motion of the table over time. None for a cam without a motion of its master: the ticks over a
/// live master need none.
std::optional<Reference> table_over_time(const Input& input, bool live) {
  try {
    return table_reference(input);
  } catch (const InputError& error) {
    if (!live || error.key() != "master" || !std::holds_alternative<Cam>(*input.curve)) throw;
    return std::nullopt;
  }
}

Played played(const Input& input, const std::string& log) {
  const std::vector<PlayedTick> ticks = read_played(read_file(log), log);
  const auto table = table_over_time(input, ticks.front().master.has_value());
  Designed designed;
  if (table) {
    designed.over_time.table = [&](double t) { return at(*table, t); };
    designed.duration = duration(*table);
  }
  const auto* const sync = input.spec ? std::get_if<SyncSpec>(&input.spec->subject) : nullptr;
  designed.cutter = sync != nullptr && cut_list_of(*sync).has_value();
  if (input.spec) designed.ramp = input.spec->coupling;
  // At a cut, the streamer lets a cam that advances begin at any pass.
  const auto& positions = input.table.table.columns().p;
  if (designed.ramp && !designed.ramp->slave_period &&
      input.table.table.outside() == Extrapolation::advance)
    designed.ramp->slave_period = std::abs(positions.back() - positions.front());
  const Cam* const cam = std::get_if<Cam>(&*input.curve);
  // A log may contain places of the master at which the cam is not defined.
  const Table& of_master = input.table.table;
  const auto within = [&](double master) {
    return of_master.outside() == Extrapolation::refuse
               ? std::clamp(master, of_master.start(), of_master.end())
               : master;
  };
  if (cam != nullptr)
    designed.over_master.table = [&](double master) {
      const Jet jet = of_master.jet(within(master));
      return Motion{jet[0], jet[1], jet[2], jet[3]};
    };
  std::optional<Reference> curve;
  if (const auto tolerance = table_tolerance(input)) {
    if (table) {
      curve = exact_reference(input);
      designed.over_time.curve = [&](double t) { return at(*curve, t).position; };
    }
    if (cam != nullptr)
      designed.over_master.curve = [&](double master) { return cam->at(within(master)).position; };
    designed.tolerance = *tolerance;
  }
  try {
    return compare_played(ticks, designed);
  } catch (const InputError& error) {
    throw error.document().empty() ? InputError(error).at(log) : error;
  }
}

std::string played_text(const Played& played, const std::string& unit) {
  const auto part = [&](const Deviation& from, const char* what) {
    return fmt::format("at most {} {} from the {} (limit {})", rounded(from.error), unit, what,
                       rounded(from.limit));
  };
  std::string text = fmt::format(
      "  {:<12} {}: job {} from {} s of the log, {} ticks{}{}{}, {}", "executor",
      played.report.ok() ? "ok" : "BROKEN", played.job, rounded(played.start), played.ticks,
      played.live ? " over the live master (the end is not checked)" : "",
      played.left_out > 0 ? fmt::format(" after the ramp ({} ticks, not compared)", played.left_out)
                          : "",
      played.shift != 0 ? fmt::format(", shifted by {} {}", rounded(played.shift), unit) : "",
      part(played.table, "table"));
  if (played.curve) text += ", " + part(*played.curve, "exact curve");
  return text + "\n";
}

Json played_json(const Played& played) {
  const auto part = [](const Deviation& from) {
    return Json{{"error", from.error}, {"where", from.where}, {"limit", from.limit}};
  };
  Json json{{"job", played.job},          {"start", played.start},
            {"ticks", played.ticks},      {"ticks_left_out", played.left_out},
            {"shift", played.shift},      {"live_master", played.live},
            {"table", part(played.table)}};
  if (played.curve) json["curve"] = part(*played.curve);
  return json;
}

/// The drive over its tolerances. Errors of a tolerance get the place of [drive.tolerances].
ToleranceResult tolerated(const Input& input, const ProofProgress& progress) {
  const Reference reference = table_reference(input);
  try {
    return robustness(view(reference), *input.drive, progress);
  } catch (const InputError& error) {
    const std::string own = "tolerances.";
    if (!input.spec || !error.key().starts_with(own)) throw;
    throw input.spec->document.located(
        InputError("drive.tolerances", "",
                   error.key().substr(own.size()) + " = " + error.value() + " " + error.rule()));
  }
}

}  // namespace

Proof prove(const Input& input, const ProofOptions& options) {
  // The velocity of a table of straight lines steps. That of an input without another curve steps,
  // too, and that of a table over time, each of whose segments has its own velocities.
  const WitnessOptions of_table{.velocity_steps =
                                    input.table.table.rule() == Interpolation::linear};
  const bool time_table = input.spec && std::holds_alternative<TimeTableSpec>(input.spec->subject);
  const WitnessOptions of_curve{.velocity_steps =
                                    time_table || (of_table.velocity_steps && !input.error)};
  Proof proof{std::visit([&](const auto& curve) { return witness(curve, of_curve); }, *input.curve),
              witness(input.table.table, of_table),
              std::nullopt,
              std::nullopt,
              {}};
  add_part(proof.report, proof.curve.report, "exact curve");
  add_part(proof.report, proof.table.report, "table");
  Report fit = check_all(input);
  proof.breaks_limits = std::any_of(fit.findings.begin(), fit.findings.end(), [](const Finding& f) {
    return f.broken && f.rule.family() == RuleFamily::limit;
  });
  std::erase_if(fit.findings, [](const Finding& f) {
    return f.rule != "table/position" && f.rule != "warning/older_table";
  });
  add_part(proof.report, fit, "table");
  if (input.drive) {
    constexpr std::size_t compared = 201;
    proof.drive = driven(input, options.drive_samples > 0 ? options.drive_samples : compared);
    add_torque_demand(*proof.drive, input);
    add_part(proof.report, proof.drive->report, "drive", "s");
    if (input.drive->tolerances) {
      proof.tolerances = tolerated(input, options.progress);
      add_part(proof.report, proof.tolerances->report, "drive");
    }
  }
  if (input.spec && input.spec->follower) {
    proof.follower = followed(input, options.drive_samples);
    add_part(proof.report, proof.follower->report, "follower", "s");
  }
  if (!options.log.empty()) {
    proof.played = played(input, options.log);
    add_part(proof.report, proof.played->report, "executor", "s");
  }
  in_position_unit(proof.report, input.labels.units.position);
  sort(proof.report);
  return proof;
}

std::string proof_text(const Proof& proof, const Input& input) {
  const std::string& u = input.labels.units.position;
  std::string text;
  const auto line = [&](const char* who, const std::string& says) {
    text += fmt::format("  {:<12} {}\n", who, says);
  };
  for (const auto& [who, w] : {std::pair{"exact curve", &proof.curve}, {"table", &proof.table}})
    line(who, fmt::format("{}: three integrations of the jerk agree with position, velocity, "
                          "acceleration to {:.1e}, {:.1e}, {:.1e} of their ranges ({} steps)",
                          w->report.ok() ? "ok" : "BROKEN", w->position.relative,
                          w->velocity.relative, w->acceleration.relative, w->integration.steps));
  if (proof.drive) text += drive_text(*proof.drive, *input.drive, u);
  if (proof.tolerances) text += robustness_text(*proof.tolerances, u);
  if (proof.follower) text += follower_text(*proof.follower, u);
  if (proof.played) text += played_text(*proof.played, u);
  return text;
}

std::string proof_json(const Proof& proof, const Input& input) {
  Json document = Json::parse(to_json(proof.report, input.labels));
  const auto witness_json = [](const Witness& w) {
    return Json{{"position", w.position.relative},
                {"velocity", w.velocity.relative},
                {"acceleration", w.acceleration.relative},
                {"steps", w.integration.steps}};
  };
  document["witness"] = {{"curve", witness_json(proof.curve)},
                         {"table", witness_json(proof.table)}};
  if (proof.drive) document["drive"] = drive_json(*proof.drive, *input.drive);
  if (proof.tolerances) document["tolerances"] = robustness_json(*proof.tolerances);
  if (proof.follower) document["follower"] = follower_json(*proof.follower);
  if (proof.played) document["executor"] = played_json(*proof.played);
  return document.dump();
}

std::string proof_answer(const Proof& proof, const Input& input) {
  std::string text =
      fmt::format("{}: {}\n{}", input.name, proof.report.ok() ? "proven" : "NOT proven",
                  proof_text(proof, input));
  if (!proof.drive)
    text += fmt::format("  {:<12} not checked: only a spec with a [drive] has a servo model\n",
                        "drive");
  if (proof.breaks_limits)
    text += fmt::format(
        "  {:<12} warn: not part of the proof, but the motion breaks one: `jounce check` shows "
        "where\n",
        "limits");
  for (const Finding& f : proof.report.findings)
    if (f.rule == "warning/older_table")
      text += fmt::format("  {:<12} warn: {}\n  {:<12} -> {}\n", "table", sentence(f, input.labels),
                          "", f.advice);
  if (!proof.report.ok()) text += "\n" + full_text(proof.report, input.labels);
  return text;
}

}  // namespace jounce
