// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "jounce/base/detail/listed.hpp"
#include "jounce/base/units.hpp"
#include "jounce/design/make.hpp"
#include "jounce/report/report_text.hpp"
#include "jounce/spec/spec.hpp"

/// The outcome of an optimization of free shapes, in the words and units of its spec.
namespace jounce::study_detail {

/// Names of the numbers of an outcome.
class ShapeWords {
 public:
  explicit ShapeWords(const Spec& spec)
      : spec_(spec), cam_(std::get<CamSpec>(spec.subject)), labels_{spec.units, true, {}} {
    for (std::size_t i = 0; i < cam_.segments.size(); ++i) labels_.segments.push_back(segment(i));
  }

  [[nodiscard]] const Labels& labels() const { return labels_; }
  /// The cam of the spec, as it is given.
  [[nodiscard]] const CamSpec& cam() const { return cam_; }
  [[nodiscard]] const std::vector<ShapeFigureSpec>& figures() const {
    return spec_.optimize.shape.figures;
  }

  /// Name of the figure that is minimized at present.
  [[nodiscard]] std::string stage(const OptimizeProgress& progress) const {
    return figures()[std::min(progress.stage, figures().size() - 1)].name;
  }

  /// Number of figures that are minimized; the others are ceilings.
  [[nodiscard]] std::size_t minimized() const {
    return figures().size() - spec_.optimize.shape.ceilings.size();
  }

  /// Returns number and name of a segment: "2 sync".
  [[nodiscard]] std::string segment(std::size_t i) const {
    const std::string& name = cam_.segments[i].name;
    return std::to_string(i + 1) + (name.empty() ? "" : " " + name);
  }

  /// Returns the segments of a run, separated by commas.
  [[nodiscard]] std::string segments(const CamRunOutcome& run) const {
    return listed(run.segments, [&](std::size_t i) { return segment(i); });
  }

  /// Returns a place as a master position of the cam: a run may extend beyond the end of the
  /// period.
  [[nodiscard]] double place(double where) const {
    const double start = cam_.start.master;
    const double end = cam_.segments.back().end.master;
    return where > end ? where - (end - start) : where;
  }

  /// Returns a place in words: "120 deg (segment 2 sync)".
  [[nodiscard]] std::string at(double where, const CamRunOutcome& run) const {
    return fmt::format("{} {} (segment {})", rounded(place(where)), spec_.units.x,
                       segment(index_at(where, run)));
  }

  /// Gives a rate over time the unit of its limit in the spec: "m/s^2".
  void give_unit(Finding& finding) const {
    for (std::size_t k = 1; k < OverTime::names.size(); ++k) {
      if (finding.quantity != OverTime::names[k] || !finding.unit.empty()) continue;
      const auto [unit, size] =
          unit_in_spec(rate_unit(spec_.units.position, spec_.time_unit, static_cast<int>(k)));
      finding.unit = unit;
      finding.value *= size;
      finding.limit *= size;
    }
  }

  /// Returns the unit in which the spec limits a rate over time, and its size: "m/s^2" for "mm/s^2".
  [[nodiscard]] std::pair<std::string, double> unit_in_spec(const std::string& unit) const {
    for (std::size_t k = 1; k < OverTime::names.size(); ++k) {
      const std::string own = rate_unit(spec_.units.position, spec_.time_unit, static_cast<int>(k));
      if (unit != own) continue;
      const std::string given =
          spec_.document.given_unit(std::string("limits.slave.") + OverTime::names[k], own);
      return {given, conversion(own, given)};
    }
    return {unit, 1};
  }

  /// Returns the findings on a run with the places and the segments of the cam, not of the run.
  [[nodiscard]] Report in_cam(Report report, const CamRunOutcome& run) const {
    for (Finding& finding : report.findings) {
      if (finding.segment) finding.segment = index_at(finding.where, run);
      finding.where = place(finding.where);
      give_unit(finding);
    }
    return report;
  }

  /// Returns the length of a run, master units.
  [[nodiscard]] double length(const CamRunOutcome& run) const {
    double length = 0;
    for (const std::size_t i : run.segments) length += cam_.segments[i].end.master - begin(i);
    return length;
  }

 private:
  /// The segment of a run at a place.
  [[nodiscard]] std::size_t index_at(double where, const CamRunOutcome& run) const {
    const double here = place(where);
    std::size_t i = run.segments.front();
    for (const std::size_t each : run.segments)
      if (here >= begin(each) && here <= cam_.segments[each].end.master) i = each;
    return i;
  }

  [[nodiscard]] double begin(std::size_t i) const {
    return i == 0 ? cam_.start.master : cam_.segments[i - 1].end.master;
  }

  const Spec& spec_;
  const CamSpec& cam_;
  Labels labels_;
};

/// A figure of a run, with the numbers that are printed.
struct PrintedFigure {
  const ShapeFigureSpec& spec;
  double given;
  double reached;
  std::optional<double> bound;
  std::optional<double> could_save;  ///< greatest possible improvement, as a share of `reached`
};

/// Returns the figures of a run. For a figure that is minimized alone, `could_save` uses its bound
/// or the bound of its splines, whichever is greater.
std::vector<PrintedFigure> printed_figures(const CamRunOutcome& run, const ShapeWords& words);

/// Returns the limit with the least margin among those that are not reached yet; null: none.
const Finding* next_limit(const CamRunOutcome& run);

}  // namespace jounce::study_detail
