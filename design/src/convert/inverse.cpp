// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/inverse.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/base/units.hpp"
#include "jounce/cam/algebra/algebra.hpp"
#include "jounce/design/detail/design_text.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

#include "design/src/input/file_name.hpp"
#include "design/src/make/table_of.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

constexpr double fit_share = 1e-9;  ///< default tolerance, as a share of the length of the cam

const Cam& cam_in(const Input& input) {
  if (const auto* cam = std::get_if<Cam>(&*input.curve)) return *cam;
  throw InputError("FILE", design_detail::file_name(input),
                   "is a motion over time; only a cam has an inverse");
}

std::optional<double> given(const char* key, const std::string& text, const std::string& unit) {
  if (text.empty()) return std::nullopt;
  try {
    return quantity(text, unit);
  } catch (const InputError& error) {
    throw InputError(key, text, error.rule());
  }
}

std::string name_of(const Input& input, const Cam& cam, double master) {
  const std::size_t segment = segment_at(cam, master);
  const auto& names = input.labels.segments;
  return segment < names.size() ? names[segment] : std::to_string(segment + 1);
}

/// An end of a branch as text: 0 if it is only rounding beside the other end.
std::string without_rounding(double end, double other) {
  return rounded(std::abs(end) <= profiles_detail::rounded_input * std::abs(other) ? 0 : end);
}

const char* kind_of(const Inverse& branch) {
  return branch.rises() ? "rise" : "fall";
}

/// The branch at a master position, or the only one.
const Inverse& chosen(const Input& input, const Inversion& all, const std::optional<double>& at) {
  const std::string unit = input.labels.units.x.empty() ? "" : " " + input.labels.units.x;
  if (at) {
    if (const Inverse* branch = all.branch_at(*at)) return *branch;
    throw InputError("at", rounded(*at) + unit,
                     "must lie in a rise or fall of the slave, " + all.ranges_text() + unit);
  }
  if (all.branches.empty())
    throw InputError("FILE", design_detail::file_name(input), "has a slave that never moves");
  if (all.branches.size() > 1)
    throw InputError(
        "at", "",
        fmt::format("is missing: the cam has {} rises and falls. Give a master position "
                    "inside the one that you need ({}{}), such as {}{}",
                    all.branches.size(), all.ranges_text(), unit,
                    rounded((all.branches[0].master_from() + all.branches[0].master_to()) / 2),
                    unit));
  return all.branches.front();
}

/// Throws InputError, for an end of the range, if the slave rests there.
/// `option`: its text; "" if the position is the end of the branch.
void require_motion_at(const Inverse& branch, double slave, Side side, const char* key,
                       const std::string& option, const std::string& unit) {
  if (slave < branch.start() || slave > branch.end())
    throw InputError(key, number(slave) + " " + unit,
                     fmt::format("must lie within the rise or fall, {} to {} {}",
                                 without_rounding(branch.start(), branch.end()),
                                 without_rounding(branch.end(), branch.start()), unit));
  if (!std::isfinite(branch.at(slave, side).geo_velocity))
    throw InputError(
        key, option.empty() ? "" : number(slave) + " " + unit,
        fmt::format("{} where the slave is at rest, so the slope of the inverse is "
                    "infinite: give a position between {} and {} {}",
                    option.empty() ? "is missing: the rise or fall " +
                                         std::string(side == Side::right ? "begins" : "ends")
                                   : "is",
                    rounded(branch.start()), rounded(branch.end()), unit));
}

}  // namespace

std::vector<MasterPlace> places_of_slave(const Input& input, const std::string& slave) {
  const Cam& cam = cam_in(input);
  std::vector<MasterPlace> all;
  for (const MasterSpan& span :
       positions_for(cam, *given("slave", slave, input.labels.units.position)))
    all.push_back({span, name_of(input, cam, (span.from + span.to) / 2)});
  return all;
}

Input inverse_of(const Input& input, const InverseTexts& texts) {
  const Cam& cam = cam_in(input);
  const Units& units = input.labels.units;
  const Inversion all = inverted(cam);
  const Inverse& branch = chosen(input, all, given("at", texts.at, units.x));
  const double from = given("from", texts.from, units.position).value_or(branch.start());
  const double to = given("to", texts.to, units.position).value_or(branch.end());
  const double tolerance =
      given("tolerance", texts.tolerance, units.x).value_or(fit_share * cam.length());
  if (!(tolerance > 0)) throw InputError("tolerance", texts.tolerance, "must be greater than 0");
  require_motion_at(branch, from, Side::right, "from", texts.from, units.position);
  require_motion_at(branch, to, Side::left, "to", texts.to, units.position);
  if (!(from < to))
    throw InputError("to", number(to) + " " + units.position,
                     "must be greater than --from = " + number(from) + " " + units.position);
  const Fitted<OverMaster> fitted = [&] {
    try {
      return inverse_within(branch, from, to, tolerance / 2);
    } catch (const InputError& error) {
      if (error.key() != "tolerance" || texts.tolerance.empty()) throw;
      throw InputError("tolerance", texts.tolerance,
                       "is divided between the inverse and its table: each half, in " + units.x +
                           ", " + error.rule());
    }
  }();
  Sampled table = design_detail::table_of(
      fitted.curve, {.rule = {}, .tolerance = tolerance / 2, .intervals = {}}, {});
  table.error.position += fitted.error[0];
  table.error.velocity += fitted.error[1];
  Labels labels{{units.position, units.x}, true, {}};
  const auto breaks = fitted.curve.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    labels.segments.push_back(
        name_of(input, cam, fitted.curve.jet((breaks[i] + breaks[i + 1]) / 2)[0]));
  TableFile file{std::move(table.table), labels.units, input.table.provenance};
  return {std::nullopt,
          fitted.curve,
          std::move(file),
          table.error,
          {},
          std::move(labels),
          fmt::format("{}, inverse of the {}", input.name, kind_of(branch)),
          ""};
}

namespace {

std::string inverse_text(const Input& input) {
  const Cam& cam = cam_in(input);
  const Units& units = input.labels.units;
  const Inversion all = inverted(cam);
  std::string text = fmt::format(
      "{}: the inverse has {}\n", input.name,
      all.branches.size() == 1 ? "1 branch" : std::to_string(all.branches.size()) + " branches");
  for (const Inverse& branch : all.branches)
    text += fmt::format("  {} from {} to {} {}: slave {} to {} {}\n", kind_of(branch),
                        rounded(branch.master_from()), rounded(branch.master_to()), units.x,
                        without_rounding(branch.start(), branch.end()),
                        without_rounding(branch.end(), branch.start()), units.position);
  for (const Finding& f : all.report.findings)
    text += fmt::format("  {} at {} {}: {}\n", f.rule.text(), rounded(f.where), units.x, f.advice);
  return text;
}

std::string inverse_json(const Input& input) {
  const Inversion all = inverted(cam_in(input));
  Json branches = Json::array();
  for (const Inverse& branch : all.branches)
    branches.push_back({{"kind", kind_of(branch)},
                        {"master_from", branch.master_from()},
                        {"master_to", branch.master_to()},
                        {"slave_from", branch.start()},
                        {"slave_to", branch.end()}});
  Json document{{"branches", std::move(branches)}};
  document["findings"] = Json::parse(to_json(all.report, input.labels))["findings"];
  return document.dump();
}

std::string places_text(const Input& input, const std::string& slave,
                        const std::vector<MasterPlace>& places) {
  if (places.empty()) {
    const Range travel = extrema(cam_in(input), 0);
    return fmt::format("{}: --slave = {}: is out of reach: the slave moves from {} to {} {}\n",
                       input.name, slave, rounded(travel.min.value), rounded(travel.max.value),
                       input.labels.units.position);
  }
  std::string text;
  for (const MasterPlace& place : places) {
    const MasterSpan& master = place.master;
    text += fmt::format("{}{} {} (segment {})\n", rounded(master.from),
                        master.to > master.from ? " to " + rounded(master.to) : "",
                        input.labels.units.x, place.segment);
  }
  return text;
}

std::string places_json(const std::vector<MasterPlace>& places) {
  Json list = Json::array();
  for (const MasterPlace& place : places)
    list.push_back({{"master_from", place.master.from},
                    {"master_to", place.master.to},
                    {"segment", place.segment}});
  return Json{{"places", std::move(list)}}.dump();
}

}  // namespace

InverseAnswer inverse_answer(const Input& input, const std::string& slave, const std::string& table,
                             const InverseTexts& texts) {
  if (!slave.empty()) {
    const auto places = places_of_slave(input, slave);
    return {places_text(input, slave, places), places_json(places), !places.empty()};
  }
  if (table.empty()) return {inverse_text(input), inverse_json(input)};
  Input made = inverse_of(input, texts);
  std::string text = design_text(made, {});
  std::string json = design_json(made, {}, table);
  return {std::move(text), std::move(json), true, std::move(made.table)};
}

}  // namespace jounce
