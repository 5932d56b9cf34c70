// SPDX-License-Identifier: Apache-2.0
#include "jounce/proof/identification.hpp"

#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/detail/printable.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/spec/detail/drive_file.hpp"
#include "jounce/spec/detail/text_numbers.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

std::string unit_of_quantity(const std::string& quantity, const std::string& unit) {
  return quantity == "velocity" ? unit + "/s" : quantity == "torque" ? "N m" : unit;
}

/// The recorded values of a quantity, with its unit and its label in the picture.
struct Quantity {
  const std::vector<double>& recorded;
  std::string unit;
  bool deviation;  ///< drawn and reported as its distance from the command
};

Quantity quantity_named(const Recording& run, const std::string& name, const std::string& unit) {
  const std::vector<double>& recorded = name == "position"   ? run.position
                                        : name == "load"     ? run.load
                                        : name == "velocity" ? run.velocity
                                                             : run.torque;
  return {recorded, unit_of_quantity(name, unit), name == "position" || name == "load"};
}

std::string interval(const FittedNumber& n) {
  return fmt::format("{} to {}", rounded(n.low), rounded(n.high));
}

/// "1.2 %", half the interval over the value.
std::string share(const FittedNumber& n) {
  const double half = 50 * std::abs((n.high - n.low) / n.value);
  return half < 1000 ? fmt::format("+-{:.2g} %", half) : "unknown";
}

Json json_of(const FittedNumber& n) {
  return {{"key", n.key},     {"unit", n.unit}, {"start", n.start},
          {"value", n.value}, {"low", n.low},   {"high", n.high}};
}

}  // namespace

std::string identification_text(const Identification& found, const std::string& unit) {
  std::string text = fmt::format("{}: {}\n", name(found.status), found.reason);
  if (found.numbers.empty()) return text;
  text += fmt::format("  {:<28} {:>12} {:>12} {:>12}   95 % interval\n", "", "start", "fitted", "");
  const auto add = [&](const FittedNumber& n) {
    text += fmt::format("  {:<28} {:>12} {:>12} {:>12}   {} {}\n", n.key, rounded(n.start),
                        rounded(n.value), share(n), interval(n), n.unit);
  };
  for (const FittedNumber& n : found.numbers) add(n);
  if (found.feed_forward) add(*found.feed_forward);
  for (const Explained& e : found.explained)
    text +=
        fmt::format("  residual of {:<16} {:>12} {:>12} {:>12}   {} rms\n", e.quantity,
                    rounded(e.before), rounded(e.after), "", unit_of_quantity(e.quantity, unit));
  for (const Entangled& e : found.entangled)
    if (found.reason.find(e.first + " and " + e.second + " cannot") == std::string::npos)
      text += fmt::format(
          "  - {} and {} act nearly alike in this recording (correlation {:.4f}). Their intervals "
          "include this\n",
          e.first, e.second, e.correlation);
  for (const std::string& note : found.notes)
    if (note != found.reason) text += fmt::format("  - {}\n", note);
  if (found.status == Identification::Status::converged)
    text +=
        "  next: fit another run from these numbers, which must stay within the intervals. Then "
        "copy "
        "the fitted [drive] into the spec of a motion, and run `jounce validate`\n";
  return text;
}

std::string identification_json(const Identification& found) {
  Json numbers = Json::array(), entangled = Json::array(), explained = Json::array();
  for (const FittedNumber& n : found.numbers) numbers.push_back(json_of(n));
  for (const Entangled& e : found.entangled)
    entangled.push_back({{"first", e.first}, {"second", e.second}, {"correlation", e.correlation}});
  for (const Explained& e : found.explained)
    explained.push_back({{"quantity", e.quantity},
                         {"rms_before", e.before},
                         {"rms_after", e.after},
                         {"autocorrelation", e.autocorrelation}});
  Json document{{"status", name(found.status)}, {"usable", found.usable()},
                {"reason", found.reason},       {"numbers", numbers},
                {"entangled", entangled},       {"explained", explained},
                {"notes", found.notes},         {"iterations", found.iterations}};
  if (found.feed_forward) document["feed_forward"] = json_of(*found.feed_forward);
  return document.dump();
}

Figure identification_figure(const Identification& found, const Recording& run,
                             const std::string& title, const std::string& unit) {
  Figure figure{.title = title, .x_label = "time [s]"};
  for (const Explained& e : found.explained) {
    const Quantity q = quantity_named(run, e.quantity, unit);
    std::vector<double> recorded = q.recorded, model = e.model, left = e.model;
    for (std::size_t i = 0; i < recorded.size(); ++i) {
      left[i] = recorded[i] - model[i];
      if (q.deviation) recorded[i] -= run.command[i], model[i] -= run.command[i];
    }
    const std::string what = e.quantity + (q.deviation ? " - command" : "");
    figure.panels.push_back({.y_label = fmt::format("{} [{}]", what, q.unit),
                             .series = {{"recorded", run.time, recorded, Style::under},
                                        {"fitted model", run.time, model}}});
    figure.panels.push_back({.y_label = fmt::format("residual [{}]", q.unit),
                             .series = {{"recorded - model", run.time, left, Style::dots}}});
  }
  return figure;
}

namespace {

/// The fitted drive alone, as a spec of kind "drive".
std::string fitted_drive_text(const Identification& found, const Spec& spec,
                              const std::string& remark) {
  DriveSpec drive = *spec.drive;
  drive.drive = found.drive;
  std::map<std::string, std::string> beside;
  for (const FittedNumber& n : found.numbers)
    beside[n.key] = "95 %: " + interval(n) + ", was " + rounded(n.start);
  return drive_text(drive, spec.units, remark, beside);
}

}  // namespace

std::string fitted_spec_text(const Identification& found, const Spec& spec,
                             const std::string& log) {
  std::string head = "Fitted to " + printable(log) + " by `jounce identify`";
  std::vector<NumberChange> changes;
  std::string lines = "# " + head + ", with 95 % intervals:\n";
  for (const FittedNumber& n : found.numbers) {
    changes.push_back({"drive." + n.key, n.value});
    lines +=
        fmt::format("#   drive.{}: {} {}, was {}\n", n.key, interval(n), n.unit, rounded(n.start));
  }
  try {
    return lines + with_numbers(spec.document, changes);
  } catch (const InputError&) {  // a number is in another file
    return fitted_drive_text(found, spec, head);
  }
}

}  // namespace jounce
