// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/slave_advice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/moves/move.hpp"

#include "design/src/check/master_check.hpp"

namespace jounce::design_detail {
namespace {

constexpr double straight = 1e-9;  ///< share of the peak: a smaller acceleration of a segment is 0
constexpr int halvings = 60;       ///< enough for the last digit of a double

/// A segment of a spec between two segments without acceleration (dwells or lines).
struct Between {
  double length = 0;        ///< travel of the master
  double from = 0, to = 0;  ///< positions of the slave
  double slope_from = 0, slope_to = 0;

  [[nodiscard]] bool rests() const { return slope_from == 0 && slope_to == 0; }
  /// True if a motion within the limits makes this segment behind a master at this speed.
  [[nodiscard]] bool is_possible(const Bounds& bounds, double speed) const {
    const Durations possible = durations({.position = from, .velocity = slope_from * speed},
                                         {.position = to, .velocity = slope_to * speed}, bounds);
    return possible.status == MoveStatus::ok && possible.allows(length / speed);
  }
};

/// The pieces of the segment to which a piece belongs; nullopt if a neighbor accelerates.
std::optional<Between> between(const Cam& cam, const Labels& labels, std::size_t piece) {
  const std::vector<SegmentGroup> all = groups(cam.segments().size(), labels);
  const auto own = std::find_if(all.begin(), all.end(), [&](const SegmentGroup& g) {
    return g.first <= piece && piece <= g.last;
  });
  if (own == all.end() || all.size() < 2) return std::nullopt;
  const double peak = std::abs(extrema(cam, 2).peak().value);
  /// The slope of a segment without acceleration.
  const auto slope_of = [&](const SegmentGroup& g, Side end) -> std::optional<double> {
    for (std::size_t i = g.first; i <= g.last; ++i)
      for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Segment& piece_of = cam.segments()[i];
        const double a = evaluate(piece_of, at)[2];
        if (std::abs(a) > straight * peak) return std::nullopt;
      }
    const double x = end == Side::left ? cam.breaks()[g.last + 1] : cam.breaks()[g.first];
    const double slope = cam.jet(x, end)[1];
    const double stroke = std::abs(extrema(cam, 1).peak().value);
    return std::abs(slope) <= straight * stroke ? 0 : slope;
  };
  const bool is_first = own == all.begin();
  const bool is_last = own + 1 == all.end();
  if ((is_first || is_last) && !repeats(cam.outside())) return std::nullopt;
  const auto before = slope_of(is_first ? all.back() : *(own - 1), Side::left);
  const auto after = slope_of(is_last ? all.front() : *(own + 1), Side::right);
  if (!before || !after) return std::nullopt;
  const double x0 = cam.breaks()[own->first];
  const double x1 = cam.breaks()[own->last + 1];
  return Between{x1 - x0, cam.jet(x0, Side::right)[0], cam.jet(x1, Side::left)[0], *before, *after};
}

/// The least limit of the derivative of this order with which the segment is possible, within the
/// other limits; infinite if the other limits prevent it.
double least_peak(const Between& part, Limits limits, std::size_t order, double speed) {
  const std::array all{&limits.velocity, &limits.acceleration, &limits.jerk};
  std::optional<double>& limit = *all[order - 1];
  const auto possible = [&](double value) {
    limit = value;
    return part.is_possible(bounds_of(limits), speed);
  };
  double low = *limit;
  double high = low;
  if (possible(low)) {
    for (int i = 0; i < halvings && possible(low); ++i) low = (high = low) / 2;
  } else {
    for (int i = 0; i < halvings && !possible(high); ++i) high = 2 * (low = high);
    if (!possible(high)) return Bounds::none;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (possible(middle) ? high : low) = middle;
  }
  return high;
}

/// The greatest speed of the master at which the segment is possible.
double fastest(const Between& part, const Limits& limits, double speed) {
  const Bounds bounds = bounds_of(limits);
  double high = speed;
  double low = speed / 2;
  for (int i = 0; i < halvings && !part.is_possible(bounds, low); ++i) low = (high = low) / 2;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (part.is_possible(bounds, middle) ? low : high) = middle;
  }
  return low;
}

/// The law with the least peak; its acceleration and jerk are 8 and 32 in units of the segment.
const char* law_of(const Between& part, const Limits& limits, std::size_t order, double speed) {
  const double duration = part.length / speed;
  const double stroke = std::abs(part.to - part.from);
  const double acceleration = 8 * stroke / (duration * duration);
  const bool is_free = !limits.acceleration || acceleration <= *limits.acceleration;
  const bool is_slow = !limits.velocity || 2 * stroke / duration <= *limits.velocity;
  return order == 3 && part.rests() && is_free && is_slow
             ? "law = \"minimum_peak_jerk\" has it"
             : "free = { shape = 60 } with `jounce optimize` comes close to it";
}

/// "the segment moves 80 mm in 110 deg (0.1222 s): the least possible jerk is 1690 m/s^3 ..."
std::string least_text(const Finding& f, std::size_t order, const Between& part,
                       const Input& input) {
  const Spec& spec = *input.spec;
  const double speed = spec.master->velocity;
  const double least = least_peak(part, spec.slave, order, speed);
  const Units& units = input.labels.units;
  std::string text = fmt::format(
      "the segment moves {} {} in {} {} ({:.4g} {}): ", rounded(std::abs(part.to - part.from)),
      units.position, rounded(part.length), units.x, part.length / speed, spec.time_unit);
  const std::string own = rate_unit(units.position, spec.time_unit, static_cast<int>(order));
  const double shown = least * conversion(own, f.unit);
  const double limit = std::abs(f.limit);
  if (std::isfinite(least))
    text += fmt::format("the least possible {} within the other limits is {} {} ({})", f.quantity,
                        six_digits_up(shown), f.unit, law_of(part, spec.slave, order, speed));
  else
    text += "no motion keeps the other limits";
  if (shown <= limit) return f.advice + "; " + text;
  const SpeedUnit unit = master_speed_unit(spec);
  const double most = fastest(part, spec.slave, speed) / unit.size;
  text += std::isfinite(least) ? ", above the limit. " : ". ";
  if (master_rates(spec).acceleration > 0)  // the ramp of the master needs a reserve
    return text + fmt::format(
                      "Slow the master down to less than {} {}, lengthen the segment, or raise "
                      "the limit",
                      six_digits_down(most), unit.name);
  return text +
         fmt::format("Slow the master down to {} {}, lengthen the segment, or raise the limit",
                     six_digits_down(most), unit.name);
}

}  // namespace

void advise_on_slave(const Input& input, Report& report) {
  const Spec& spec = *input.spec;
  if (!std::holds_alternative<CamSpec>(spec.subject) || input.against || !spec.then.empty() ||
      spec.polydyne || !(spec.master->velocity > 0))
    return;
  const Cam& cam = std::get<Cam>(*input.curve);
  std::set<std::string> advised;
  sort(report);
  for (Finding& f : report.findings) {
    const auto name = std::find(OverTime::names.begin() + 1, OverTime::names.end(), f.quantity);
    if (!f.broken || !f.segment || name == OverTime::names.end()) continue;
    const auto part = between(cam, input.labels, *f.segment);
    if (!part) continue;
    const auto order = static_cast<std::size_t>(name - OverTime::names.begin());
    const bool is_first = advised.insert(input.labels.segment_of(f)).second;
    if (is_first)
      f.advice = least_text(f, order, *part, input);
    else if (!part->is_possible(bounds_of(spec.slave), spec.master->velocity))
      f.advice = "";  // the remedy of the segment is that of its worst finding
  }
}

}  // namespace jounce::design_detail
