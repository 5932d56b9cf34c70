// SPDX-License-Identifier: Apache-2.0
#include "cli/proof/cam_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "jounce/cam/design/certificate.hpp"
#include "jounce/cam/design/characteristics.hpp"
#include "jounce/cam/design/warnings.hpp"
#include "jounce/design/master_check.hpp"
#include "jounce/design/sync_check.hpp"

#include "cli/common/json.hpp"

namespace jounce::cli {
namespace {

constexpr std::size_t most_rises = 8;

/// The design's segment of each segment of the cam: those that share a label.
std::vector<std::size_t> origin_of(const Cam& cam, const Labels& labels) {
  std::vector<std::size_t> origin;
  const auto all = groups(cam.segments().size(), labels);
  for (std::size_t g = 0; g < all.size(); ++g) origin.resize(all[g].last + 1, g);
  return origin;
}

void append(Report& all, Report part) {
  std::move(part.findings.begin(), part.findings.end(), std::back_inserter(all.findings));
}

/// Whether its rises are laws between knots that somebody chose: those of a generator for a slave in
/// step are what they must be, and no bound is asked of them.
bool is_designed(const Input& input) {
  return !input.spec || !std::holds_alternative<SyncSpec>(input.spec->subject);
}

std::string rise_line(const Rise& rise, const Labels& labels) {
  const Characteristics c = characteristics(rise);
  const Report best = certificates(rise);
  const auto front = std::find_if(best.findings.begin(), best.findings.end(), [](const Finding& f) {
    return f.rule == "bound/acceleration_for_jerk";
  });
  const auto n = fmt::format("{} .. {} {}", rounded(rise.cam.start()), rounded(rise.cam.end()),
                             labels.units.x);
  const bool uneven = std::abs(c.ca.value - c.ca_star.value) > 1e-5 * c.peak_acceleration();
  std::string line = fmt::format("  {} {:<22} Cv {:.5g}  Ca {:.5g}{}  Cj {:.5g}  Cm {:.5g}",
                                 c.stroke < 0 ? "fall" : "rise", n, c.cv.value, c.ca.value,
                                 uneven ? fmt::format("  Ca* {:.5g}", c.ca_star.value) : "",
                                 c.cj.value, c.cm.value);
  if (front != best.findings.end())
    line += fmt::format("; Ca is {:.1f} % above the least for its Cj", 100 * front->margin);
  return line + "\n";
}

std::string fastest_line(const Cam& cam, const Input& input) {
  const MasterRates rates = master_rates(*input.spec);
  if (rates.acceleration > 0 && master_accelerates_too_fast(cam, *input.spec)) {
    const MasterLimit most = greatest_master_acceleration(cam, *input.spec);
    return fmt::format(
        "  fastest acceleration of the master {} {}: the slave's {} limit, at {} {}\n",
        rounded(most.value), master_rate_unit(*input.spec, 2), most.quantity, rounded(most.where),
        input.labels.units.x);
  }
  const MasterLimit limit = greatest_master_velocity(cam, input.spec->slave, rates);
  if (std::isinf(limit.value)) return "";
  std::string line =
      fmt::format("  fastest master {} {}", rounded(limit.value), master_rate_unit(*input.spec, 1));
  if (is_made_for_a_speed(*input.spec)) line += " for this table";
  if (rates.acceleration > 0)
    line += fmt::format(" while it accelerates with {} {}", rounded(rates.acceleration),
                        master_rate_unit(*input.spec, 2));
  return line + fmt::format(": the slave's {} limit, at {} {}\n", limit.quantity,
                            rounded(limit.where), input.labels.units.x);
}

/// What a slave in step is made of, a line each.
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

}  // namespace

void add_cam_findings(Report& report, const Input& input, int continuity) {
  if (!input.labels.over_master) return;
  const Cam& cam = std::get<Cam>(*input.curve);
  Report odd = warnings(cam, origin_of(cam, input.labels));
  for (int k = 0; k <= continuity; ++k)
    std::erase_if(odd.findings, [&](const Finding& f) {
      return f.rule == std::string("joint/") + OverMaster::names[static_cast<std::size_t>(k)];
    });
  const bool told =
      std::any_of(report.findings.begin(), report.findings.end(),
                  [](const Finding& f) { return f.broken && f.rule == "knife/reversal"; });
  if (told)  // with what to do about it
    std::erase_if(odd.findings, [](const Finding& f) { return f.rule == "warning/reversal"; });
  append(report, std::move(odd));
  if (is_designed(input)) append(report, certificates(cam));
  if (input.spec && has_slave_limits(*input.spec) && input.spec->master)
    report.findings.push_back(master_finding(cam, *input.spec));
  sort(report);
}

Report checked(const Input& input, int continuity, const EngageState& at) {
  Report report = check_all(input, continuity, at);
  add_cam_findings(report, input, continuity);
  return report;
}

std::string cam_text(const Input& input) {
  if (!input.labels.over_master) return "";
  const Cam& cam = std::get<Cam>(*input.curve);
  std::string text = figure_lines(input);
  const auto all = is_designed(input) ? rises(cam) : std::vector<Rise>{};
  for (std::size_t i = 0; i < std::min(most_rises, all.size()); ++i)
    text += rise_line(all[i], input.labels);
  if (all.size() > most_rises)
    text += fmt::format("  ... and {} more rises\n", all.size() - most_rises);
  if (input.spec && has_slave_limits(*input.spec)) text += fastest_line(cam, input);
  return text;
}

Json cam_json(const Input& input) {
  if (!input.labels.over_master) return nullptr;
  const Cam& cam = std::get<Cam>(*input.curve);
  Json list = Json::array();
  for (const Rise& rise : rises(cam)) list.push_back(json_of(rise));
  Json document{{"rises", std::move(list)}};
  if (Json figures = figures_json(input); !figures.empty()) document["sync"] = std::move(figures);
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

}  // namespace jounce::cli
