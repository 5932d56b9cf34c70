// SPDX-License-Identifier: Apache-2.0
// Fills in the derivatives of a spec and makes its segments.
//
// Velocities come first, because accelerations follow from them. Their order of precedence: the
// given value; the requirement of a line, a dwell or a reversal; the value of a spline at an open
// end; zero. Then accelerations: given, then required. Finally the segments are built from left to
// right; a segment that defines an acceleration itself sets it at its knots.
#include "cam/src/design/resolve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cam_detail {
namespace {

using profiles_detail::rounded_input;
using profiles_detail::rounded_sum;
constexpr double largest = 1e100;  // up to here, squares and quotients of derivatives are finite

class Resolver {
 public:
  explicit Resolver(const CamSpec& spec) : spec_(spec) {
    if (spec.segments.empty())
      throw InputError("segment", "", "is missing: a cam needs at least one [[segment]]");
    for (std::size_t i = 0; i <= spec.segments.size(); ++i) add_knot(i);
    if (spec.slave_period) require_whole_turns();
  }

  std::vector<Placed> resolve() {
    for (std::size_t i = 0; i < spec_.segments.size(); ++i) demand(i);
    for (std::size_t i = 0; i < spec_.segments.size(); ++i)
      if (info(law(i)).ends == Ends::moving_to_reversal) demand_reversal(i);
    for (std::size_t i = 0; i < spec_.segments.size(); ++i) require_form_and_points(i);
    share_seam();
    for (std::size_t i = 0; i < spec_.segments.size(); ++i)
      if (is_spline(law(i)) || law(i) == Law::hermite || law(i) == Law::b_spline) take_open_ends(i);
    share_seam();
    for (CamKnot& knot : knots_) knot.geo_velocity = knot.geo_velocity.value_or(0);
    std::vector<Placed> placed;
    for (std::size_t i = 0; i < spec_.segments.size(); ++i) {
      placed.push_back(place(i, placed));
      take_own_accelerations(placed.back(), i);
    }
    share_seam();
    for (std::size_t i = 0; i < placed.size(); ++i) {
      placed[i].from = filled(knots_[i]);
      placed[i].to = filled(knots_[i + 1]);
    }
    return placed;
  }

 private:
  [[nodiscard]] const CamKnot& given(std::size_t i) const {
    return i == 0 ? spec_.start : spec_.segments[i - 1].end;
  }
  [[nodiscard]] Law law(std::size_t segment) const { return spec_.segments[segment].law; }
  [[nodiscard]] double chord(std::size_t i) const {
    return (knots_[i + 1].slave - knots_[i].slave) / (knots_[i + 1].master - knots_[i].master);
  }
  static CamKnot filled(CamKnot knot) {
    knot.geo_acceleration = knot.geo_acceleration.value_or(0);
    return knot;
  }

  /// The previous (-1) or next (1) segment, also across the end of the period.
  [[nodiscard]] std::optional<std::size_t> beside(std::size_t segment, int step) const {
    const std::size_t count = spec_.segments.size();
    const bool outside = step < 0 ? segment == 0 : segment + 1 == count;
    if (outside && (!spec_.periodic || count == 1)) return std::nullopt;
    return (segment + count + static_cast<std::size_t>(step < 0 ? count - 1 : 1)) % count;
  }
  /// True for a line or a dwell, which need no velocity of their knots.
  [[nodiscard]] bool is_straight(std::size_t segment) const {
    const Ends ends = info(law(segment)).ends;
    return ends == Ends::straight || ends == Ends::standing;
  }
  /// True if the segment has acceleration 0 at its ends.
  [[nodiscard]] bool rests(std::size_t segment) const {
    const Ends ends = info(law(segment)).ends;
    return ends == Ends::straight || ends == Ends::standing || ends == Ends::moving;
  }

  void add_knot(std::size_t i);
  void require_whole_turns() const;
  void require_form_and_points(std::size_t segment) const;
  void require_jerk_is_taken(std::size_t knot) const;
  void demand(std::size_t segment);
  void demand_reversal(std::size_t segment);
  void demand_at(std::size_t knot, std::optional<double> CamKnot::*field, const char* name,
                 double demanded, std::size_t segment, double scale);
  [[noreturn]] void fail_step(std::size_t knot, double before, double demanded,
                              std::size_t segment) const;
  void share_seam();
  Placed place(std::size_t segment, const std::vector<Placed>& before) const;
  [[nodiscard]] bool reversal_first(std::size_t segment, const std::vector<Placed>& before) const;
  void require_no_rest(std::size_t segment, bool reversal_first) const;
  void find_inflection(Placed& placed, std::size_t segment) const;
  void take_own_accelerations(const Placed& placed, std::size_t segment);
  void take_open_ends(std::size_t segment);
  void take_controlled_ends(std::size_t segment, const Jet& from, const Jet& to);
  void take_own(std::size_t knot, double own, std::size_t segment, double scale);

  const CamSpec& spec_;
  std::vector<CamKnot> knots_;
  std::vector<bool> demanded_;  ///< for each knot: true if a law required its velocity
};

void Resolver::add_knot(std::size_t i) {
  const CamKnot& knot = given(i);
  require_finite(key_of(i, "master").c_str(), knot.master);
  require_finite(key_of(i, "slave").c_str(), knot.slave);
  for (const auto& [field, value] : {std::pair{"master", knot.master}, {"slave", knot.slave}})
    if (std::abs(value) > largest)
      throw InputError(key_of(i, field), value, "must be at most 1e100 in magnitude");
  if (knot.geo_velocity) require_finite(key_of(i, "geo_velocity").c_str(), *knot.geo_velocity);
  if (knot.geo_acceleration)
    require_finite(key_of(i, "geo_acceleration").c_str(), *knot.geo_acceleration);
  if (knot.geo_jerk) require_jerk_is_taken(i);
  if (i > 0 && !(knot.master > knots_.back().master))
    throw InputError(
        key_of(i, "master"), knot.master,
        "must be greater than " + number(knots_.back().master) + ", the previous knot");
  knots_.push_back(knot);
  demanded_.push_back(false);
}

void Resolver::require_jerk_is_taken(std::size_t i) const {
  require_finite(key_of(i, "geo_jerk").c_str(), *given(i).geo_jerk);
  const std::size_t last = spec_.segments.size();
  const bool taken = (i > 0 && takes_jerk(law(i - 1))) || (i < last && takes_jerk(law(i))) ||
                     (spec_.periodic && i == 0 && takes_jerk(law(last - 1))) ||
                     (spec_.periodic && i == last && takes_jerk(law(0)));
  if (!taken)
    throw InputError(key_of(i, "geo_jerk"), *given(i).geo_jerk,
                     "needs a law with a given jerk before or after this knot: septic or nonic");
}

void Resolver::require_whole_turns() const {
  const double period = *spec_.slave_period;
  require_positive("slave_period", period);
  if (!spec_.periodic)
    throw InputError(
        "slave_period", period,
        "needs a periodic cam on a rotary slave; this cam is not periodic: add periodic = true, or "
        "leave slave_period out");
  const double advance = knots_.back().slave - knots_.front().slave;
  const double turns = std::round(advance / period);
  const double scale = std::max(std::abs(knots_.back().slave), std::abs(knots_.front().slave));
  if (std::abs(advance - turns * period) > rounded_sum * std::max(scale, period))
    throw InputError(
        key_of(spec_.segments.size(), "slave"), knots_.back().slave,
        "must differ from the start of the cam by a whole number of turns, slave_period "
        "= " +
            number(period) +
            ": the nearest is slave = " + number(knots_.front().slave + turns * period));
}

void Resolver::require_form_and_points(std::size_t i) const {
  const CamSegment& segment = spec_.segments[i];
  try {
    require_valid(segment.law, segment.form);
  } catch (const InputError& error) {
    throw InputError("segment[" + std::to_string(i + 1) + "]." + error.key(), error.value(),
                     error.rule());
  }
  const std::string key = "segment[" + std::to_string(i + 1) + "].points";
  if (!takes_points(segment.law) && !segment.points.empty())
    throw InputError(key, "",
                     std::string("the law ") + name(segment.law) +
                         " takes no points: leave them out, or use polynomial, cubic_spline, "
                         "quintic_spline or hermite");
  for (std::size_t p = 0; p < segment.points.size(); ++p) {
    const double master = segment.points[p].master;
    const std::string point = key + "[" + std::to_string(p + 1) + "].master";
    require_finite(point.c_str(), master);
    if (master < knots_[i].master || master > knots_[i + 1].master)
      throw InputError(point, master,
                       "must lie in its segment, " + number(knots_[i].master) + " to " +
                           number(knots_[i + 1].master));
    if (p > 0 && !(master > segment.points[p - 1].master))
      throw InputError(
          point, master,
          "must be greater than " + number(segment.points[p - 1].master) + ", the previous point");
  }
}

/// Handles a derivative that an adjacent law requires at a knot: sets it, or checks the given one.
void Resolver::demand_at(std::size_t knot, std::optional<double> CamKnot::*field, const char* name,
                         double demanded, std::size_t segment, double scale) {
  auto& value = knots_[knot].*field;
  const bool is_velocity = field == &CamKnot::geo_velocity;
  if (!value && is_velocity) demanded_[knot] = true;
  if (!value) value = demanded;
  if (std::abs(*value - demanded) <= rounded_input * scale) return;
  if (is_velocity && demanded_[knot]) {
    if (spec_.velocity_steps && is_straight(segment) && knot > 0 && is_straight(knot - 1)) return;
    fail_step(knot, *value, demanded, segment);
  }
  throw InputError(key_of(knot, name), *value,
                   "must be " + six_digits(demanded) + ", the value of the adjacent law `" +
                       jounce::name(law(segment)) + "`: change this number or that law");
}

/// Two adjacent laws require different velocities at their common knot. The line, which has a velocity, is named.
void Resolver::fail_step(std::size_t knot, double before, double demanded,
                         std::size_t segment) const {
  const std::size_t last = spec_.segments.size() - 1;
  const std::size_t beside =
      segment < knot ? std::min(knot, last) : std::max<std::size_t>(knot, 1) - 1;
  const bool is_line = info(law(segment)).ends == Ends::straight;
  const std::size_t line = is_line ? segment : beside;
  const std::size_t other = is_line ? beside : segment;
  const double own = is_line ? demanded : before;
  const double others = is_line ? before : demanded;
  throw InputError("segment[" + std::to_string(line + 1) + "].law",
                   std::string("\"") + name(law(line)) + '"',
                   std::string(line == knot ? "begins" : "ends") + " at master " +
                       number(knots_[knot].master) + " with the slope " + six_digits(own) +
                       ", but the adjacent segment " + std::to_string(other + 1) + " (" +
                       name(law(other)) + ") has the slope " + six_digits(others) + " there: " +
                       (others == 0 ? "use a law from rest to rest, such as modified_sine"
                                    : "put a segment with the law quintic between the two, or, for "
                                      "a controller that joins positions by straight lines, give "
                                      "[table] rule = \"linear\""));
}

void Resolver::demand(std::size_t i) {
  const Ends ends = info(law(i)).ends;
  if (ends == Ends::standing && knots_[i].slave != knots_[i + 1].slave)
    throw InputError(
        key_of(i + 1, "slave"), knots_[i + 1].slave,
        "must be " + number(knots_[i].slave) +
            ", the position where this dwell starts: change one of the two, or the law");
  const double slope = chord(i);
  const double velocity = ends == Ends::straight ? slope : 0;
  for (std::size_t k = i; k <= i + 1; ++k) {
    if (ends == Ends::straight || ends == Ends::standing || ends == Ends::rest_to_reversal)
      demand_at(k, &CamKnot::geo_velocity, "geo_velocity", velocity, i, std::abs(slope));
    if (rests(i))
      demand_at(k, &CamKnot::geo_acceleration, "geo_acceleration", 0, i,
                std::abs(slope) / (knots_[i + 1].master - knots_[i].master));
  }
}

/// A law from a constant velocity to a reversal has velocity 0 at the reversal. Without any velocity, both ends are at
/// rest.
void Resolver::demand_reversal(std::size_t i) {
  const double scale = std::abs(chord(i));
  const auto moves = [&](std::size_t knot) {
    return std::abs(knots_[knot].geo_velocity.value_or(0)) > rounded_input * scale;
  };
  if (!moves(i + 1)) demand_at(i + 1, &CamKnot::geo_velocity, "geo_velocity", 0, i, scale);
  if (!moves(i) || moves(i + 1)) demand_at(i, &CamKnot::geo_velocity, "geo_velocity", 0, i, scale);
}

/// The first and the last knot of a periodic cam are one place: each gets the values that it lacks from the other. They
/// stay two knots, because two given values, or the demands of two laws, may differ: a check finds this step.
void Resolver::share_seam() {
  if (!spec_.periodic) return;
  for (const auto field :
       {&CamKnot::geo_velocity, &CamKnot::geo_acceleration, &CamKnot::geo_jerk}) {
    auto& first = knots_.front().*field;
    auto& last = knots_.back().*field;
    if (!first) first = last;
    if (!last) last = first;
  }
}

bool Resolver::reversal_first(std::size_t i, const std::vector<Placed>& before) const {
  if (info(law(i)).ends == Ends::moving_to_reversal) {
    if (*knots_[i].geo_velocity != 0) return false;
    if (*knots_[i + 1].geo_velocity != 0) return true;
  }
  if (given(i).geo_acceleration) return *given(i).geo_acceleration != 0;
  if (given(i + 1).geo_acceleration) return *given(i + 1).geo_acceleration == 0;
  const auto previous = beside(i, -1);
  const auto next = beside(i, 1);
  // outside, a cam that holds is at rest
  const bool rest_before = previous ? rests(*previous) : !spec_.periodic;
  const bool rest_after = next ? rests(*next) : !spec_.periodic;
  if (rest_before != rest_after) return rest_after;
  if (i == 0) return false;
  const Ends ends = info(law(i - 1)).ends;
  return ends == Ends::moving_free || (reverses(ends) && !before[i - 1].reversed);
}

void Resolver::require_no_rest(std::size_t i, bool reversal_first) const {
  const std::size_t knot = reversal_first ? i : i + 1;
  const auto neighbor = beside(i, reversal_first ? -1 : 1);
  if (!neighbor || !rests(*neighbor)) return;
  throw InputError(
      "segment[" + std::to_string(i + 1) + "].law", std::string("\"") + name(law(i)) + '"',
      "reverses at master " + number(knots_[knot].master) + ", where the adjacent law `" +
          name(law(*neighbor)) + "` has no acceleration: use a law from rest to rest");
}

/// Computes the inflection if the knot of the reversal gives an acceleration that the law can have.
void Resolver::find_inflection(Placed& placed, std::size_t i) const {
  const std::size_t knot = placed.reversed ? i : i + 1;
  const auto& wanted = given(knot).geo_acceleration;
  if (!wanted || placed.form.inflection || !info(placed.spec->law).inflection) return;
  const double stroke = placed.to.slave - placed.from.slave;
  if (stroke == 0)
    throw InputError(key_of(knot, "geo_acceleration"), *wanted,
                     "must be left out: the segment has no stroke");
  const double unit = (placed.reversed ? 1 : -1) * stroke / (placed.length() * placed.length());
  const double deceleration = *wanted / unit;
  const double least = least_deceleration(placed.spec->law);
  if (!(deceleration > least))
    throw InputError(key_of(knot, "geo_acceleration"), *wanted,
                     std::string(unit > 0 ? "must be greater than " : "must be less than ") +
                         six_digits(least * unit) + ": otherwise the inflection of the law `" +
                         name(placed.spec->law) + "` is outside its segment");
  const std::size_t other = placed.reversed ? i + 1 : i;
  const double velocity = *knots_[other].geo_velocity * placed.length() / stroke;
  if (!(velocity < greatest_velocity(placed.spec->law)))
    throw InputError(
        key_of(other, "geo_velocity"), *knots_[other].geo_velocity,
        "must be below " +
            six_digits(greatest_velocity(placed.spec->law) * stroke / placed.length()) +
            ", because the reversal of this segment has geo_acceleration: replace "
            "geo_acceleration by inflection, or lengthen the segment");
  placed.form.inflection = inflection_for(placed.spec->law, deceleration, velocity);
  if (!(*placed.form.inflection < 1))
    throw InputError(key_of(knot, "geo_acceleration"), *wanted,
                     "is too large: the inflection of the law `" +
                         std::string(name(placed.spec->law)) + "` would be at its reversal");
}

Placed Resolver::place(std::size_t i, const std::vector<Placed>& before) const {
  const CamSegment& segment = spec_.segments[i];
  Placed placed{i, &segment, segment.form, false, knots_[i], knots_[i + 1]};
  if (!reverses(info(segment.law).ends)) return placed;
  placed.reversed = reversal_first(i, before);
  require_no_rest(i, placed.reversed);
  find_inflection(placed, i);
  return placed;
}

/// Sets the acceleration of a knot at which a law defines its own, if there is no other value. A
/// value given by the spec must agree. A value that a neighbor requires may differ: this is a step,
/// which a check finds.
void Resolver::take_own(std::size_t knot, double own, std::size_t segment, double scale) {
  if (given(knot).geo_acceleration)
    demand_at(knot, &CamKnot::geo_acceleration, "geo_acceleration", own, segment, scale);
  else if (!knots_[knot].geo_acceleration)
    knots_[knot].geo_acceleration = own;
}

/// A spline is natural at an end without given derivatives, and a hermite law has its own points at
/// its ends. The neighbor then gets the same derivatives.
void Resolver::take_open_ends(std::size_t i) {
  const bool alone = spec_.periodic && spec_.segments.size() == 1;
  const auto segments = built({i, &spec_.segments[i], {}, false, knots_[i], knots_[i + 1], alone});
  const auto& points = spec_.segments[i].points;
  const auto own_at = [&](const CamKnot& knot, const CamPoint& point, Jet jet) {
    if (point.master != knot.master) return jet;  // a point at the end coincides to the bit
    jet[1] = point.geo_velocity.value_or(jet[1]);
    jet[2] = point.geo_acceleration.value_or(jet[2]);
    return jet;
  };
  Jet from = evaluate(segments.front(), 0);
  Jet to = evaluate(segments.back(), 1);
  if (!points.empty()) from = own_at(knots_[i], points.front(), from);
  if (!points.empty()) to = own_at(knots_[i + 1], points.back(), to);
  if (law(i) == Law::b_spline) return take_controlled_ends(i, from, to);
  const auto take = [](CamKnot& knot, const Jet& own, bool bends) {
    if (!knot.geo_velocity) knot.geo_velocity = own[1];
    if (bends && !knot.geo_acceleration) knot.geo_acceleration = own[2];
  };
  const bool bends = info(law(i)).ends == Ends::given;
  take(knots_[i], from, bends);
  share_seam();
  take(knots_[i + 1], to, bends);
  share_seam();
}

/// The control values of a B-spline determine its derivatives. A velocity that another law requires must agree.
void Resolver::take_controlled_ends(std::size_t i, const Jet& from, const Jet& to) {
  const double slope = std::max({std::abs(chord(i)), std::abs(from[1]), std::abs(to[1])});
  const double bend = std::max(
      {std::abs(from[2]), std::abs(to[2]), slope / (knots_[i + 1].master - knots_[i].master)});
  for (const auto& [knot, own] : {std::pair{i, &from}, {i + 1, &to}}) {
    demand_at(knot, &CamKnot::geo_velocity, "geo_velocity", (*own)[1], i, slope);
    take_own(knot, (*own)[2], i, bend);
    share_seam();
  }
}

void Resolver::take_own_accelerations(const Placed& placed, std::size_t i) {
  const Ends ends = info(placed.spec->law).ends;
  if (ends != Ends::moving_free && !reverses(ends)) return;
  const auto segments = built(placed);
  const double from = evaluate(segments.front(), 0)[2];
  const double to = evaluate(segments.back(), 1)[2];
  const double scale =
      std::max({std::abs(from), std::abs(to), std::abs(chord(i)) / placed.length()});
  const bool reversal = reverses(ends);
  take_own(i, reversal && !placed.reversed ? 0 : from, i, scale);
  take_own(i + 1, reversal && placed.reversed ? 0 : to, i, scale);
}

}  // namespace

std::string key_of(std::size_t knot, const char* field) {
  return knot == 0 ? std::string("start.") + field
                   : "segment[" + std::to_string(knot) + "].end." + field;
}

std::vector<Placed> resolve(const CamSpec& spec) {
  return Resolver(spec).resolve();
}

}  // namespace jounce::cam_detail
