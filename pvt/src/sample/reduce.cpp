// SPDX-License-Identifier: Apache-2.0
#include "jounce/pvt/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/check.hpp"

#include "pvt/src/sample/best_places.hpp"
#include "pvt/src/sample/halves.hpp"
#include "pvt/src/sample/longest.hpp"
#include "pvt/src/sample/stretches.hpp"
#include "pvt/src/sample/whole_steps.hpp"
#include "pvt/src/sample/within_limits.hpp"

// The error of an interval depends only on its two knots. So a table in which each interval is as
// long as possible has the fewest knots. By induction, its i-th knot is at or beyond the i-th knot
// of any other table, if
//
//   (1)  an interval that keeps the tolerance keeps it from any later beginning.
//
// (1) holds if the k-th derivative of the curve falls or grows slowly, by the bound h^k M / C of
// the error. It may fail if a derivative steps: an interval from just before the break is shorter
// than one from the break. So
//
//   (2)  the search continues from the farthest knot and from the breaks next to it,
//
// for each number of knots from the few farthest ones. Required knots (stretches.cpp) divide the
// curve into such problems. At the end, knots that can be omitted are removed. If all tolerances
// are multiplied by s, the number of knots n(s) falls as s grows. The least s with n(s) <= n gives
// the best table of n knots, and bisection finds it.
//
// If (1) does not hold, the result is only near the best. So tables with few knots are also
// searched
//
//   (3)  over places, by dynamic programming (best_places.cpp),
//
// and the better one is taken.
namespace jounce {
namespace {

using profiles_detail::inf;
using profiles_detail::rounded_digit;
using pvt_detail::Knot;
using pvt_detail::Straight;
using pvt_detail::Tolerances;

constexpr std::size_t many = 1'000'000;
/// If there are more knots than this, a too short last interval hardly changes the others.
constexpr std::size_t worth_levelling = 200;
constexpr std::size_t worth_keeping = 4;  ///< number of nodes that are kept in a layer

struct Attempt {
  std::vector<Knot> knots;
  double scale = 0;      ///< factor of the tolerances
  bool reaches = false;  ///< true if the end of the curve is reached
  /// True if no interval from the last knot keeps the tolerances; false if too many knots are
  /// necessary.
  bool stuck = false;
};

/// A knot, and the node before it in the sequence of fewest knots that leads to it.
struct Node {
  Knot knot;
  std::size_t from = 0;
  double length = 0;  ///< length of the interval between them
};

template <class Over>
class Reduction {
 public:
  Reduction(const Curve<Over>& f, const Target& target)
      : f_(f), target_(target), stretches_(pvt_detail::kept_stretches(f, target)) {
    for (const Segment& segment : f.segments()) floor_ = std::max(floor_, magnitude(segment));
    floor_ *= rounded_digit;
    const Range travel = extrema(f, 0);
    const double stroke = travel.max.value - travel.min.value;
    const bool any = target.tolerance || target.velocity_tolerance;
    asked_ = {target.tolerance.value_or(any || stroke == 0 ? inf : stroke),
              target.velocity_tolerance.value_or(inf)};
  }

  Sampled run(const Limits& limits, const RampedLimits& ramped) {
    const bool any = target_.tolerance || target_.velocity_tolerance;
    const std::size_t most = most_ends();
    Attempt found = attempt(1, most);
    if (!found.reaches) {
      auto other = searched(1, {}, most, any);
      if (!other) refuse(found);
      found = std::move(*other);
    }
    if (!any)
      found = least(std::move(found), most, 1.0 / 16);
    else if (const std::size_t n = found.knots.size(); n > 2 && n <= worth_levelling)
      found = least(std::move(found), n, 0.7 * std::pow(1 - 1.0 / static_cast<double>(n), order()));
    found = better(std::move(found), most, any);
    return within(limits, ramped,
                  needed(std::move(found.knots), tolerances(any ? 1 : found.scale)));
  }

 private:
  [[nodiscard]] int order() const { return pvt_detail::order(target_); }

  /// The permitted number of ends of intervals. Quadratic pieces need two knots for each interval,
  /// except for the first end.
  [[nodiscard]] std::size_t most_ends() const {
    const std::size_t most = target_.most.value_or(many);
    return target_.quadratic ? (most - 1) / 2 + 1 : most;
  }

  [[nodiscard]] Tolerances tolerances(double scale) const {
    return {std::max(scale * asked_.position, floor_), scale * asked_.velocity};
  }

  /// The table of fewest knots for `scale` times the tolerances; stops if more than `most` knots
  /// are necessary. Layer i contains the i-th knots of all promising tables; see (2).
  [[nodiscard]] Attempt attempt(double scale, std::size_t most) const {
    const Tolerances allowed = tolerances(scale);
    const std::vector<Straight> kept = kept_within(allowed);
    std::vector<Node> nodes{
        {pvt_detail::held_at(f_, target_, f_.start(), Side::right), 0, f_.length()}};
    std::size_t first = 0;  // first node of the last layer
    for (std::size_t count = 2; count <= most; ++count) {
      const std::size_t last = nodes.size();
      for (std::size_t i = first; i < last; ++i) {
        const Node node = nodes[i];
        for (const Knot& next :
             pvt_detail::followers(f_, target_, node.knot, allowed, kept, node.length))
          nodes.push_back({next, i, next.x - node.knot.x});
      }
      if (nodes.size() == last) return {path(nodes, first), scale, false, true};
      keep_farthest(nodes, last);
      first = last;
      if (nodes[first].knot.x >= f_.end()) return {path(nodes, first), scale, true, false};
    }
    return {path(nodes, first), scale, false, false};
  }

  /// The best table from the search over places, (3).
  [[nodiscard]] std::optional<Attempt> searched(double scale, const std::vector<Knot>& known,
                                                std::size_t most, bool fewest) const {
    const Tolerances allowed = tolerances(scale);
    const std::vector<Straight> kept = kept_within(allowed);
    auto best = pvt_detail::best_over_places(f_, target_, allowed, kept, known, most, fewest);
    if (!best) return std::nullopt;
    return Attempt{std::move(best->knots), scale * best->share, true, false};
  }

  /// `found`, or a table from the search over places that has fewer knots or an error at least 1 %
  /// smaller.
  [[nodiscard]] Attempt better(Attempt found, std::size_t most, bool any) const {
    const std::size_t n = found.knots.size();
    auto other = searched(any ? 1 : found.scale, found.knots, any ? n : most, any);
    if (!other) return found;
    const bool fewer = any && other->knots.size() < n;
    return fewer || other->scale < 0.99 * found.scale ? std::move(*other) : found;
  }

  /// All dwells, and the straight lines that keep the tolerances although their ends are rounded.
  [[nodiscard]] std::vector<Straight> kept_within(const Tolerances& allowed) const {
    std::vector<Straight> kept = stretches_;
    std::erase_if(kept, [&](const Straight& each) {
      return !each.dwell && pvt_detail::share(f_, target_, each.begin, each.end, allowed) > 1;
    });
    return kept;
  }

  /// Keeps only the few farthest of the nodes from `first` on, in descending order.
  static void keep_farthest(std::vector<Node>& nodes, std::size_t first) {
    const auto begin = nodes.begin() + static_cast<std::ptrdiff_t>(first);
    std::stable_sort(begin, nodes.end(),
                     [](const Node& a, const Node& b) { return a.knot.x > b.knot.x; });
    const auto same = [](const Node& a, const Node& b) {
      return a.knot.x == b.knot.x && a.knot.side == b.knot.side;
    };
    nodes.erase(std::unique(begin, nodes.end(), same), nodes.end());
    nodes.resize(std::min(nodes.size(), first + worth_keeping));
  }

  static std::vector<Knot> path(const std::vector<Node>& nodes, std::size_t last) {
    std::vector<Knot> knots{nodes[last].knot};
    for (std::size_t i = last; i != 0; knots.push_back(nodes[i].knot)) i = nodes[i].from;
    std::reverse(knots.begin(), knots.end());
    return knots;
  }

  /// `found` with the least scale, to 1 %, for which `most` knots are sufficient. `factor` < 1 is
  /// tried first.
  [[nodiscard]] Attempt least(Attempt found, std::size_t most, double factor) const {
    double lo = 0;
    while (lo == 0 && found.scale * asked_.position > floor_ && found.scale > rounded_digit) {
      const double scale = found.scale * factor;
      Attempt tried = attempt(scale, most);
      if (tried.reaches)
        found = std::move(tried);
      else
        lo = scale;
      factor *= factor;
    }
    while (lo > 0 && found.scale > 1.01 * lo) {
      Attempt tried = attempt(std::sqrt(lo * found.scale), most);
      if (tried.reaches)
        found = std::move(tried);
      else
        lo = tried.scale;
    }
    return found;
  }

  /// The knots without those whose two intervals can be joined to one.
  [[nodiscard]] std::vector<Knot> needed(std::vector<Knot> knots, const Tolerances& allowed) const {
    std::vector<double> fixed;
    for (const Straight& each : kept_within(allowed))
      fixed.insert(fixed.end(), {each.begin.x, each.end.x});
    for (std::size_t before = 0; before != knots.size();) {
      before = knots.size();
      std::vector<Knot> kept{knots.front()};
      for (std::size_t i = 1; i + 1 < knots.size(); ++i)
        if (std::binary_search(fixed.begin(), fixed.end(), knots[i].x) ||
            pvt_detail::share(f_, target_, kept.back(), knots[i + 1], allowed) > 1)
          kept.push_back(knots[i]);
      kept.push_back(knots.back());
      knots = std::move(kept);
    }
    return knots;
  }

  /// The knots at the ends, and those between two quadratic pieces.
  [[nodiscard]] std::vector<Knot> all_of(const std::vector<Knot>& ends) const {
    if (!target_.quadratic) return ends;
    std::vector<Knot> all{ends.front()};
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const bool one = pvt_detail::is_one_quadratic(ends[i - 1], ends[i]);
      if (const auto between = pvt_detail::knot_between(target_, ends[i - 1], ends[i]);
          between && !one)
        all.push_back(*between);
      all.push_back(ends[i]);
    }
    return all;
  }

  [[nodiscard]] Sampled made(const std::vector<Knot>& ends) const {
    Columns columns;
    for (const Knot& knot : all_of(ends)) {
      columns.x.push_back(pvt_detail::rounded_to(knot.x, target_.x_step));
      columns.p.push_back(knot.jet[0]);
      if (target_.rule != Interpolation::linear) columns.v.push_back(knot.jet[1]);
      if (target_.rule == Interpolation::quintic_hermite) columns.a.push_back(knot.jet[2]);
    }
    Sampled made = certified(f_, target_.rule, std::move(columns));
    made.binding = binding_of(made);
    return made;
  }

  /// The table of these knots, and of more where it exceeds a limit that the curve keeps, if the
  /// target permits more.
  [[nodiscard]] Sampled within(const Limits& limits, const RampedLimits& ramped,
                               const std::vector<Knot>& knots) const {
    Sampled table = made(knots);
    const bool anywhere = target_.x_step == 0 && target_.p_step == 0 && target_.v_step == 0;
    if (!anywhere || target_.quadratic) return table;
    if (ramped.ramp == 0 && check(table.table, limits).ok()) return table;
    const std::vector<Knot> all =
        pvt_detail::knots_within_limits(f_, target_.rule, limits, ramped, knots, target_.spacing);
    if (all.size() > most_ends()) return table;
    Sampled more = made(all);
    const bool keeps = more.error.position <= std::max(table.error.position, asked_.position) &&
                       more.error.velocity <= std::max(table.error.velocity, asked_.velocity);
    return keeps ? std::move(more) : std::move(table);
  }

  [[nodiscard]] Binding binding_of(const Sampled& made) const {
    if (made.table.size() == 2) return Binding::none;
    if (!target_.tolerance && !target_.velocity_tolerance) return Binding::most;
    const bool velocity =
        made.error.velocity / asked_.velocity > made.error.position / asked_.position;
    return velocity ? Binding::velocity_tolerance : Binding::tolerance;
  }

  // ---- the message for a target that cannot be met

  /// A tolerance with three digits, rounded up.
  static std::string digits(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 2);
    return number(pvt_detail::steps(std::ceil(value / unit), unit));
  }

  [[nodiscard]] std::string tolerances_times(double scale) const {
    std::string text;
    if (target_.tolerance) text = "tolerance = " + digits(scale * asked_.position);
    if (target_.velocity_tolerance)
      text += (text.empty() ? "" : " and ") +
              ("velocity_tolerance = " + digits(scale * asked_.velocity));
    return text;
  }

  /// The least scale of the tolerances for which `most` knots are sufficient; 0 if there is none.
  [[nodiscard]] double scale_for(std::size_t most) const {
    double scale = 1;
    for (int i = 0; i < 40; ++i) {
      scale *= 8;
      Attempt tried = attempt(scale, most);
      if (tried.reaches) return least(std::move(tried), most, 1.0 / 8).scale;
    }
    return 0;
  }

  /// The reason why no tolerance makes the table shorter.
  [[nodiscard]] std::string lines() const {
    const std::size_t n = stretches_.size();
    if (n == 0) return "";
    return n == 1 ? ": both ends of the dwell or straight line of the motion need a knot"
                  : ": both ends of each of the " + std::to_string(n) +
                        " dwells and straight lines of the motion need a knot";
  }

  [[noreturn]] void refuse(const Attempt& failed) const {
    const double length = f_.end() - f_.start();
    if (target_.spacing > length)
      throw InputError("spacing", target_.spacing,
                       "must be at most " + number(length) + ", the length of the motion");
    const std::string table =
        std::string("a ") + (target_.quadratic ? "quadratic" : name(target_.rule)) + " table";
    const std::string where = (std::is_same_v<Over, OverTime> ? " at the time " : " at master ") +
                              number(failed.knots.back().x);
    if (!failed.stuck && !target_.most)
      throw InputError(target_.tolerance ? "tolerance" : "velocity_tolerance",
                       target_.tolerance ? asked_.position : asked_.velocity,
                       "needs more than " + std::to_string(many) + " knots in " + table +
                           ": give a greater tolerance");
    if (!failed.stuck) {
      const Attempt enough = attempt(1, many);
      const bool any = target_.tolerance || target_.velocity_tolerance;
      const double scale = any ? scale_for(most_ends()) : 0;
      const std::string count =
          "must be at least " + std::to_string(all_of(enough.knots).size()) + " for " + table;
      throw InputError("most", std::to_string(*target_.most),
                       (enough.reaches ? count + (any ? " within the tolerance" : "") +
                                             (scale > 0 ? "" : lines())
                                       : "are too few knots") +
                           (scale > 0 ? "; " + std::to_string(*target_.most) +
                                            " knots are sufficient for " + tolerances_times(scale)
                                      : ""));
    }
    if (!target_.tolerance && !target_.velocity_tolerance)
      throw InputError("most", std::to_string(target_.most.value_or(many)),
                       table + " with such knots ends" + where +
                           ": the curve steps there, or the spacing or resolution permits no knot");
    const double scale = scale_for(most_ends());
    const bool position = target_.tolerance.has_value();
    throw InputError(
        position ? "tolerance" : "velocity_tolerance", position ? asked_.position : asked_.velocity,
        "cannot be kept by " + table + where +
            (scale > 0 || target_.spacing > 0 || target_.x_step > 0
                 ? ": the curve steps there, or the spacing or the resolution permits no knot"
                 : ": the curve steps there") +
            (scale > 0 ? ". Give at least " + tolerances_times(scale) : ""));
  }

  const Curve<Over>& f_;
  const Target& target_;
  std::vector<Straight> stretches_;  ///< intervals that the table must contain
  Tolerances asked_;
  double floor_ = 0;  ///< least position tolerance: the rounding of the curve
};

void require_valid(const Target& target) {
  if (!target.tolerance && !target.velocity_tolerance && !target.most)
    throw InputError("tolerance", "",
                     "is missing: new knots need a tolerance of the position or of the velocity; a "
                     "resolution does not replace it");
  if (target.tolerance) require_positive("tolerance", *target.tolerance);
  if (target.velocity_tolerance) require_positive("velocity_tolerance", *target.velocity_tolerance);
  if (target.quadratic && target.rule != Interpolation::cubic_hermite)
    throw InputError("rule", name(target.rule), "must be cubic_hermite for quadratic pieces");
  for (const auto& [key, step] : {std::pair{"p_step", target.p_step}, {"v_step", target.v_step}})
    if (target.quadratic && step != 0)
      throw InputError(key, step,
                       "cannot be used with quadratic pieces, which carry each rounding on to the "
                       "next end: leave it out");
  require_not_negative("spacing", target.spacing);
  require_not_negative("x_step", target.x_step);
  require_not_negative("p_step", target.p_step);
  require_not_negative("v_step", target.v_step);
}

/// The curve, with ends at which knots are possible: if it holds outside, it is extended to the
/// next multiple of x_step.
template <class Over>
Curve<Over> on_steps(const Curve<Over>& f, const Target& target) {
  const double x_step = target.x_step;
  const auto whole = [&](double x) { return x_step == 0 || pvt_detail::is_whole(x, x_step); };
  if (!whole(f.start()))
    throw InputError(
        "x_step", x_step,
        "must divide the start of the curve, " + number(f.start()) + ", without remainder");
  if (target.p_step > 0 && !pvt_detail::is_whole(f.advance(), target.p_step))
    throw InputError("p_step", target.p_step,
                     "must divide the advance of a period, " + number(f.advance()) +
                         ", without remainder: otherwise the slave drifts");
  if (whole(f.end())) return f;
  if (f.outside() != Extrapolation::hold)
    throw InputError("x_step", x_step,
                     std::string("must divide the end of the ") +
                         (repeats(f.outside()) ? "period, " : "curve, ") + number(f.end()) +
                         ", without remainder");
  std::vector<Segment> segments(f.segments().begin(), f.segments().end());
  const double last = value(segments.back(), 1);
  const double end = pvt_detail::steps(std::ceil(f.end() / x_step), x_step);
  segments.push_back(line(end - f.end(), last, last));
  return Curve<Over>(std::move(segments), f.start(), f.outside());
}

}  // namespace

/// Rejects a number of knots below two, with the number that the curve needs.
template <class Over>
[[noreturn]] void refuse_single(const Curve<Over>& f, const Target& target) {
  const auto rejection = [&](const std::string& rule) {
    return InputError("most", std::to_string(*target.most), rule);
  };
  Target two = target;
  two.most = 2;
  try {
    (void)reduced(f, two, {}, {});
  } catch (const InputError& error) {
    if (error.key() == "most") throw rejection(error.rule());
    throw;
  }
  throw rejection("must be at least 2");
}

template <class Over>
Sampled reduced(const Curve<Over>& f, const Target& target, const Limits& limits,
                const RampedLimits& ramped) {
  require_valid(target);
  if (target.most && *target.most < 2) refuse_single(f, target);
  const Curve<Over> whole = on_steps(f, target);
  return Reduction<Over>(whole, target).run(limits, ramped);
}

template <class Over>
Sampled reduced(const Fitted<Over>& f, const Target& target) {
  Target rest = target;
  const auto take_off = [](const char* key, std::optional<double>& tolerance, double error) {
    if (tolerance && !(*tolerance > error))
      throw InputError(key, *tolerance,
                       "must be above " + six_digits_up(error) + ", the error of the fit");
    if (tolerance) *tolerance -= error;
  };
  take_off("tolerance", rest.tolerance, f.error[0]);
  take_off("velocity_tolerance", rest.velocity_tolerance, f.error[1]);
  Sampled made = reduced(f.curve, rest);
  made.error.position += f.error[0];
  made.error.velocity += f.error[1];
  return made;
}

#define JOUNCE_INSTANTIATE(Over)                                                                   \
  template Sampled reduced(const Curve<Over>&, const Target&, const Limits&, const RampedLimits&); \
  template Sampled reduced(const Fitted<Over>&, const Target&);
JOUNCE_INSTANTIATE(OverTime)
JOUNCE_INSTANTIATE(OverMaster)
#undef JOUNCE_INSTANTIATE

}  // namespace jounce
