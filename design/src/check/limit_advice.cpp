// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/limit_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/six_digits.hpp"

namespace jounce {
namespace {

/// The least peak of the derivative of order k of any motion from rest to rest, for a stroke and a
/// length of 1. The least peak velocity is the mean velocity, so it holds for all motions.
constexpr std::array least_peaks{0.0, 1.0, 4.0, 32.0};

constexpr double rest = 1e-9;    ///< share of the peak: a smaller value at an end is 0
constexpr double beside = 1e-6;  ///< share of a piece: a peak that is so close to its end is there

/// The segment of the spec to which a piece belongs.
struct Stretch {
  double length = 0;
  double stroke = 0;    ///< signed
  bool rests = false;   ///< the derivatives below that of the limit are 0 at both ends
  bool still = false;   ///< velocity and acceleration are 0 at both ends: the shape scales
  bool at_end = false;  ///< the finding is at an end of its piece
};

/// The part of a motion from x0 to x1, to which the finding belongs.
template <class Over>
Stretch stretch_between(const Curve<Over>& f, double x0, double x1, const Finding& finding,
                        std::size_t order) {
  Stretch s;
  s.length = x1 - x0;
  const Jet begin = f.jet(x0, Side::right);
  const Jet end = f.jet(x1, Side::left);
  s.stroke = end[0] - begin[0];
  const auto is_still = [&](std::size_t below) {
    for (std::size_t k = 1; k < below; ++k) {
      const double scale =
          rest * least_peaks[k] * std::abs(s.stroke) / std::pow(s.length, static_cast<double>(k));
      if (std::abs(begin[k]) > scale || std::abs(end[k]) > scale) return false;
    }
    return true;
  };
  s.rests = is_still(order);
  s.still = is_still(3);
  const double near = beside * s.length;
  s.at_end = finding.where <= x0 + near || finding.where >= x1 - near;
  return s;
}

/// The same for all pieces of the segment of the spec to which the piece of the finding belongs.
template <class Over>
Stretch stretch_of(const Curve<Over>& f, const Labels& labels, const Finding& finding,
                   std::size_t order) {
  const std::size_t count = f.segments().size();
  const auto label = [&](std::size_t i) {
    return i < labels.segments.size() ? labels.segments[i] : std::to_string(i + 1);
  };
  const std::size_t piece = *finding.segment;
  std::size_t first = piece;
  std::size_t last = piece;
  while (first > 0 && label(first - 1) == label(piece)) --first;
  while (last + 1 < count && label(last + 1) == label(piece)) ++last;
  return stretch_between(f, f.breaks()[first], f.breaks()[last + 1], finding, order);
}

/// The part of a cam over the segment of a spec whose index the finding has.
Stretch stretch_of(const CamDesign& cam, const CamSpec& spec, const Finding& finding,
                   std::size_t order) {
  const std::size_t i = std::min(*finding.segment, spec.segments.size() - 1);
  const double x0 = i == 0 ? spec.start.master : spec.segments[i - 1].end.master;
  return stretch_between(cam.cam, x0, spec.segments[i].end.master, finding, order);
}

/// The order of the derivative of a broken limit with a segment; 0 for any other finding.
std::size_t order_of(const Finding& f, const std::array<const char*, 4>& names) {
  if (!f.broken || !f.segment || f.rule.family() != RuleFamily::limit || f.limit == 0) return 0;
  const auto name = std::find(names.begin() + 1, names.end(), std::string_view(f.quantity));
  return name == names.end() ? 0 : static_cast<std::size_t>(name - names.begin());
}

/// Numbers with the units of a motion.
struct Words {
  const Labels& labels;

  [[nodiscard]] std::string x(double value) const {
    return fmt::format("{:.4g} {}", value, labels.units.x);
  }
  /// A length, rounded up, so that the limit holds with it.
  [[nodiscard]] std::string at_least(double length) const {
    const double unit = std::pow(10, std::floor(std::log10(length)) - 3);
    return x(std::ceil(length / unit) * unit);
  }
  [[nodiscard]] std::string of(double value, std::size_t order) const {
    const std::string unit =
        rate_unit(labels.units.position, labels.units.x, static_cast<int>(order));
    return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
  }
};

/// "segment 1 rise moves 50 mm in 120 deg, so its geo_velocity ...": "" if a law may keep the limit.
std::string impossible(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                       const std::string& who) {
  const double k = static_cast<double>(order);
  const double needed = least_peaks[order] * std::abs(s.stroke) / std::pow(s.length, k);
  const double limit = std::abs(f.limit);
  if (!s.rests || needed <= limit) return "";
  const std::string why =
      order == 1
          ? fmt::format("its mean {} is {}", f.quantity, words.of(needed, 1))
          : fmt::format("any law reaches a {} of at least {}", f.quantity, words.of(needed, order));
  return fmt::format(
      "{} moves {} in {}: {}, above the limit {}. Lengthen the segment to more than {}, or raise "
      "the limit",
      who, words.of(std::abs(s.stroke), 0), words.x(s.length), why, words.of(limit, order),
      words.at_least(s.length * std::pow(needed / limit, 1 / k)));
}

constexpr std::array coefficients{"", "velocity", "acceleration", "jerk"};

std::string cam_advice(const Finding& f, std::size_t order, const Stretch& s, const Words& words) {
  if (std::string text = impossible(f, order, s, words, "the segment"); !text.empty()) return text;
  const double longer = std::pow(std::abs(f.value / f.limit), 1.0 / static_cast<double>(order));
  return fmt::format(
      "lengthen the segment{}, or use a law with a lower {} coefficient",
      s.still && s.stroke != 0 ? " to at least " + words.at_least(s.length * longer) : "",
      coefficients[order]);
}

/// The advice for a table of points with velocities (kind "pvt").
std::string points_advice(const Finding& f, std::size_t order, const Stretch& s, const Words& words,
                          const std::optional<double>& velocity) {
  const double mean = s.stroke / s.length;
  if (order == 1 && std::abs(mean) > std::abs(f.limit))
    return fmt::format(
        "the segment moves {} in {}: its mean velocity is {}, above the limit {}. Give the segment "
        "more than {}, or raise the limit",
        words.of(std::abs(s.stroke), 0), words.x(s.length), words.of(std::abs(mean), 1),
        words.of(std::abs(f.limit), 1), words.at_least(std::abs(s.stroke / f.limit)));
  if (order == 1 && s.at_end)
    return fmt::format(
        "the point at {} has the velocity {}: {} {}", words.x(f.where), words.of(f.value, 1),
        f.limit > 0 ? "lower it to at most" : "raise it to at least", words.of(f.limit, 1));
  const std::string closer = fmt::format(
      "choose velocities of the two points of the segment that are closer to its mean velocity, {}",
      words.of(mean, 1));
  if (order == 1) return closer;
  return velocity && std::abs(mean) > *velocity
             ? "give the segment more time, or raise the limit"
             : closer + ", or give the segment more time and lower velocities";
}

/// The advice for a motion that a generator makes from its velocity, acceleration and jerk.
std::string motion_advice(const Finding& f, std::size_t order, const Words& words) {
  return fmt::format("lower the {} of the motion to at most {}, or raise the limit",
                     coefficients[order], words.of(std::abs(f.limit), order));
}

/// The advice for a table from a file.
std::string table_advice(const Finding& f, std::size_t order, double length, const Words& words) {
  const double slower = std::pow(std::abs(f.value / f.limit), 1.0 / static_cast<double>(order));
  return fmt::format("slow the whole motion down, from {} to at least {}, or raise the limit",
                     words.x(length), words.at_least(length * slower));
}

/// The advice for a limit of the position over time.
std::string position_advice(const Input& input, const Finding& f) {
  if (!input.spec) return "shift or shorten the motion, or raise the limit";
  if (!std::holds_alternative<Table>(input.spec->subject) || !input.spec->then.empty())
    return "move the target into the position range, or widen the range";
  const Trajectory& curve = std::get<Trajectory>(*input.curve);
  if (stretch_of(curve, input.labels, f, 0).at_end)
    return "move this point into the position range, or widen the range";
  return "the curve leaves the range between two points: lower the velocities of these points";
}

std::string over_time(const Input& input, const Finding& f, std::size_t order) {
  const Words words{input.labels};
  const Table& table = input.table.table;
  if (!input.spec) return table_advice(f, order, table.end() - table.start(), words);
  if (input.plan || input.overlap) return f.advice;
  const bool filled = input.spec->document.places.contains("velocities");
  if (std::holds_alternative<TimeTableSpec>(input.spec->subject) || filled)
    return "give the segment more time, or raise the limit";
  if (!std::holds_alternative<Table>(input.spec->subject) || !input.spec->then.empty())
    return motion_advice(f, order, words);
  const Trajectory& curve = std::get<Trajectory>(*input.curve);
  return points_advice(f, order, stretch_of(curve, input.labels, f, order), words,
                       input.limits.velocity);
}

}  // namespace

void advise_on_limits(const Input& input, Report& report) {
  if (input.labels.over_master) {
    for (Finding& f : report.findings)
      if (const std::size_t order = order_of(f, OverMaster::names); order > 0)
        f.advice = input.spec
                       ? cam_advice(f, order,
                                    stretch_of(std::get<Cam>(*input.curve), input.labels, f, order),
                                    {input.labels})
                       : "change the spec from which the table was made, or raise the limit";
    return;
  }
  for (Finding& f : report.findings) {
    if (const std::size_t order = order_of(f, OverTime::names); order > 0)
      f.advice = over_time(input, f, order);
    else if (f.broken && f.segment && f.rule.name().starts_with("position"))
      f.advice = position_advice(input, f);
  }
}

namespace {

bool is_position_limit(const Finding& f) {
  return f.broken && f.segment &&
         (f.rule == "limit/position_max" || f.rule == "limit/position_min");
}

/// The advice for a free shape that leaves the range of the position. The reason may be an end of its
/// segment, at the limit, where the slave moves outwards.
std::string shape_advice(const Finding& f, const CamSpec& given, const Cam& cam,
                         const Words& words) {
  const std::size_t i = std::min(*f.segment, given.segments.size() - 1);
  const double x0 = i == 0 ? given.start.master : given.segments[i - 1].end.master;
  const double x1 = given.segments[i].end.master;
  const double sign = f.value > f.limit ? 1 : -1;
  const double stroke = extrema(cam, 0).max.value - extrema(cam, 0).min.value;
  for (const auto& [x, side, outwards] :
       {std::tuple{x0, Side::right, sign}, {x1, Side::left, -sign}}) {
    const Jet at = cam.jet(x, side);
    if (std::abs(at[0] - f.limit) > rest * stroke ||
        !(outwards * at[1] > rest * stroke / (x1 - x0)))
      continue;
    return fmt::format(
        "the range ends where the slave still moves outwards: at {} it is at the limit {} and has "
        "{} "
        "{}, so every shape leaves the range. Move this knot inwards, let the slave rest there, or "
        "widen the range",
        words.x(x), words.of(f.limit, 0), OverMaster::names[1], words.of(at[1], 1));
  }
  return "every shape that keeps the other limits leaves the range: raise these limits, move the "
         "ends "
         "of the segment inwards, or widen the range";
}

}  // namespace

void advise_on_limits(const CamSpec& given, const CamSpec& made, const Labels& labels,
                      Report& report) {
  const CamDesign cam = design(made);
  std::set<std::tuple<std::string, std::size_t>> seen;  // one finding of the position a segment
  std::erase_if(report.findings, [&](const Finding& f) {
    return is_position_limit(f) && !seen.emplace(f.rule.text(), *f.segment).second;
  });
  for (Finding& f : report.findings)
    if (is_position_limit(f)) f.advice = shape_advice(f, given, cam.cam, {labels});
  for (Finding& f : report.findings)
    if (const std::size_t order = order_of(f, OverMaster::names); order > 0)
      f.advice = cam_advice(f, order, stretch_of(cam, given, f, order), {labels});
}

std::string impossible_limit(const CamSpec& given, const CamSpec& made, const Labels& labels,
                             const Report& report) {
  const CamDesign cam = design(made);
  for (const Finding& f : report.findings) {
    const std::size_t order = order_of(f, OverMaster::names);
    if (order == 0) continue;
    std::string text = impossible(f, order, stretch_of(cam, given, f, order), {labels},
                                  "segment " + labels.segment_of(f));
    if (!text.empty()) return text;
  }
  return "";
}

}  // namespace jounce
