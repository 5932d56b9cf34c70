// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/design/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"

// The quintic from rest to the slope k (or from k to rest) with stroke h over length b,
// accelerations zero. With z = x / b and rho = k b / h,
//
//   (1)  f / h  = (10 - 4 rho) z^3 + (7 rho - 15) z^4 + (6 - 3 rho) z^5
//   (2)  f' b/h = z^2 [(30 - 12 rho) + (28 rho - 60) z + (30 - 15 rho) z^2]
//   (3)  f'' b^2/h = 12 z (1 - z) [(5 - 2 rho) - 5 (2 - rho) z]
//
// The bracket in (3) is 5 - 2 rho at z = 0, 3 rho - 5 at z = 1, and linear between them. If it is
// negative at the start, the slave first moves backwards. If it is negative at the end, the
// velocity falls to k from above. Otherwise the velocity only rises.
//
//   (4)  no reversal: rho <= 5/2;   no velocity overshoot: rho >= 5/3

namespace jounce {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_value;
constexpr double ripple = 1e-3;
constexpr double rho_least = 5.0 / 3;
constexpr double rho_most = 5.0 / 2;

/// A segment of the design: the cam's segments first to last, and their extreme values.
struct Group {
  std::size_t first = 0;
  std::size_t last = 0;
  Ranges range{};
  Jet begin{};
  Jet end{};
  double length = 0;
  bool quintic = false;
};

int sign(double x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

class Inspection {
 public:
  Inspection(const Cam& cam, std::span<const std::size_t> origin) : cam_(cam), all_(extrema(cam)) {
    scale_[0] = all_[0].max.value - all_[0].min.value;
    for (std::size_t k = 1; k < 4; ++k) scale_[k] = std::abs(all_[k].peak().value);
    const std::size_t n = cam.segments().size();
    for (std::size_t i = 0, last = 0; i < n; i = last + 1) {
      last = i;
      while (last + 1 < n && last + 1 < origin.size() && origin[last + 1] == origin[i]) ++last;
      inspect(group(i, last));
    }
    joints();
    sort(report_);
  }

  [[nodiscard]] Report report() && { return std::move(report_); }

 private:
  [[nodiscard]] Group group(std::size_t first, std::size_t last) const {
    const auto& head = cam_.segments()[first];
    Group g{first, last, segment_extrema(cam_, first, last), evaluate(head, 0),
            evaluate(cam_.segments()[last], 1)};
    g.length = cam_.breaks()[last + 1] - cam_.breaks()[first];
    g.quintic = first == last && head.sines == 0 && head.degree <= 5;
    for (Jet* end : {&g.begin, &g.end})
      for (std::size_t k = 1; k < 4; ++k)
        if (std::abs((*end)[k]) <= rounded_input * scale_[k]) (*end)[k] = 0;
    return g;
  }

  void inspect(const Group& g) {
    overshoot(g, g.range[0].max, std::max(g.begin[0], g.end[0]), 1);
    overshoot(g, g.range[0].min, std::min(g.begin[0], g.end[0]), -1);
    reversal(g);
    velocity_overshoot(g);
    if (const int s = sign(g.begin[2]); s != 0 && s == sign(g.end[2]))
      against("warning/ripple", g, 2, s, ripple, Severity::warning,
              "make velocities and accelerations the derivatives of the positions");
  }

  /// Reports a position beyond the end value `edge` on the side `s` (1: above, -1: below).
  void overshoot(const Group& g, const Extremum& reached, double edge, int s) {
    const double beyond = s * (reached.value - edge);
    if (beyond <= rounded_input * scale_[0]) return;
    const bool inevitable =
        (g.begin[0] == edge && s * g.begin[1] > 0) || (g.end[0] == edge && s * g.end[1] < 0);
    add("warning/overshoot", g, 0, reached, edge, beyond,
        inevitable ? Severity::note : Severity::warning,
        inevitable ? "" : "move the knots, or lower the velocities at them");
  }

  void reversal(const Group& g) {
    const int v0 = sign(g.begin[1]);
    const int v1 = sign(g.end[1]);
    if (v0 * v1 < 0) return;
    const int way = v0 != 0 ? v0 : (v1 != 0 ? v1 : sign(g.end[0] - g.begin[0]));
    if (way == 0) return;
    // the segment ends behind its start
    const bool inevitable = sign(g.end[0] - g.begin[0]) != way;
    against("warning/reversal", g, 1, way, rounded_input,
            inevitable ? Severity::note : Severity::warning, inevitable ? "" : window(g));
  }

  /// Reports derivative k against the direction `way` by more than `share` of its peak.
  void against(const char* rule, const Group& g, std::size_t k, int way, double share,
               Severity severity, std::string advice) {
    const Extremum& worst = way > 0 ? g.range[k].min : g.range[k].max;
    const double back = -way * worst.value;
    if (back <= share * scale_[k]) return;
    add(rule, g, k, worst, 0, back, severity, std::move(advice));
    report_.findings.back().has_limit = false;
  }

  /// The end velocity of a group between rest and constant velocity.
  static std::optional<double> slope(const Group& g) {
    if (g.begin[2] != 0 || g.end[2] != 0 || (g.begin[1] == 0) == (g.end[1] == 0))
      return std::nullopt;
    return g.begin[1] + g.end[1];
  }

  void velocity_overshoot(const Group& g) {
    const auto wanted = slope(g);
    if (!wanted) return;
    const Extremum& reached = *wanted > 0 ? g.range[1].max : g.range[1].min;
    const double beyond = std::abs(reached.value) - std::abs(*wanted);
    if (beyond <= rounded_input * scale_[1]) return;
    // A slow drift after a rise: no length within the period is enough for it.
    const double stroke = (g.end[0] - g.begin[0]) * sign(*wanted);
    const bool inevitable =
        repeats(cam_.outside()) && stroke * rho_least >= cam_.length() * std::abs(*wanted);
    add("warning/velocity_overshoot", g, 1, reached, *wanted, beyond,
        inevitable ? Severity::note : Severity::warning, inevitable ? "" : window(g));
  }

  /// The window (4) in the numbers of the group, if it is such a quintic.
  [[nodiscard]] std::string window(const Group& g) const {
    const auto k = slope(g);
    const double h = g.end[0] - g.begin[0];
    if (!k || !g.quintic || h * *k <= 0) return "move the knots, or use another law";
    const auto from_to = [](double a, double b) {
      return six_digits(std::min(a, b)) + " to " + six_digits(std::max(a, b));
    };
    std::string text =
        "a quintic overshoots unless the slope of the moving end * length / stroke is "
        "5/3 to 5/2, here " +
        six_digits(*k * g.length / h) + ": use ";
    if (!repeats(cam_.outside()) || rho_most * h / *k < cam_.length())
      text += "a length from " + from_to(rho_least * h / *k, rho_most * h / *k) + ", or ";
    return text + "a stroke from " + from_to(*k * g.length / rho_most, *k * g.length / rho_least);
  }

  void add(const char* rule, const Group& g, std::size_t k, const Extremum& worst, double limit,
           double excess, Severity severity, std::string advice) {
    const auto above =
        std::upper_bound(cam_.breaks().begin() + 1, cam_.breaks().end() - 1, worst.where);
    const auto at = static_cast<std::size_t>(above - cam_.breaks().begin()) - 1;
    Finding f;
    f.rule = rule;
    f.quantity = OverMaster::names[k];
    f.where = worst.where;
    f.value = worst.value;
    f.limit = limit;
    f.margin = -excess / scale_[k];
    f.segment = std::clamp(at, g.first, g.last);
    f.advice = std::move(advice);
    f.severity = severity;
    report_.findings.push_back(std::move(f));
  }

  void joints() {
    const auto pieces = cam_.segments();
    for (std::size_t i = 1; i < pieces.size(); ++i)
      joint(evaluate(pieces[i - 1], 1), evaluate(pieces[i], 0), 0, cam_.breaks()[i], i);
    const Jet first = evaluate(pieces.front(), 0);
    const Jet last = evaluate(pieces.back(), 1);
    const std::size_t end = pieces.size() - 1;
    if (cam_.outside() == Extrapolation::hold) {
      joint({}, first, 1, cam_.start(), 0);
      joint(last, {}, 1, cam_.end(), end);
    } else if (repeats(cam_.outside())) {
      joint(last, first, cam_.outside() == Extrapolation::wrap ? 0 : 1, cam_.end(), end);
    }
  }

  /// Reports the lowest derivative, of order `lowest` or higher, that steps from `left` to `right`.
  void joint(const Jet& left, const Jet& right, std::size_t lowest, double where,
             std::size_t segment) {
    for (std::size_t k = lowest; k < left.size(); ++k) {
      const double step = std::abs(right[k] - left[k]);
      const double limit =
          std::max(rounded_input * scale_[k], rounded_value * std::abs(all_[k].peak().value));
      if (step <= limit) continue;
      Finding f;
      f.rule = Rule(RuleFamily::joint, OverMaster::names[k]);
      f.quantity = std::string("step of ") + OverMaster::names[k];
      f.where = where;
      f.value = step;
      f.limit = limit;
      f.margin = scale_[k] > 0 ? -step / scale_[k] : -1;
      f.segment = segment;
      f.severity = k == 3 ? Severity::note : Severity::warning;
      report_.findings.push_back(std::move(f));
      return;
    }
  }

  const Cam& cam_;
  Ranges all_;
  std::array<double, 4> scale_{};  ///< the travel, and the peak of each derivative
  Report report_;
};

}  // namespace

Report warnings(const Cam& cam, std::span<const std::size_t> origin) {
  return Inspection(cam, origin).report();
}

}  // namespace jounce
