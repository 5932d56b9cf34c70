// SPDX-License-Identifier: Apache-2.0
// Measured points -> a cam of few segments, see fit.hpp.
//
// The rests divide the points into motions. The state is a complete CamSpec from the beginning: a
// motion is a quintic until its law is found. A trial changes a copy of the spec, refines the knots
// beside the motion by least squares over the points near it, and is kept if it is better.
#include "jounce/cam/fit/fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/design/table.hpp"
#include "cam/src/fit/refine.hpp"
#include "cam/src/fit/rests.hpp"
#include "cam/src/fit/round.hpp"
#include "cam/src/fit/spline_part.hpp"

namespace jounce {
namespace {

using cam_detail::Deviation;
using cam_detail::Parameter;
using cam_detail::Stretch;

constexpr std::size_t least_points = 5;

void require_measured(const MeasuredCam& measured) {
  cam_detail::require_points(measured.points, least_points, true);
  for (std::size_t i = 0; i < measured.points.size(); ++i)
    if (!(measured.points[i].tolerance > 0))
      throw InputError("points[" + std::to_string(i + 1) + "].tolerance",
                       measured.points[i].tolerance, "must be greater than 0");
}

bool is_straight(Law law) {
  return law == Law::dwell || law == Law::line;
}

/// True for the laws of all motions: they take any velocities, and need no other values.
bool is_candidate(const LawInfo& law) {
  const bool joins = law.ends == Ends::moving || law.ends == Ends::moving_free;
  return joins && has_own_shape(law.law) && law.law != Law::scca &&
         law.law != Law::triple_harmonic &&
         law.law != Law::modified_sine_gg;  // between two rests it is the modified sine
}

/// Gives a law the parameters of its shape. Returns false if it has none.
bool give_form(CamSegment& segment) {
  if (info(segment.law).inflection) segment.form.inflection = 0.5;
  if (segment.law == Law::modified_constant_velocity || segment.law == Law::sine_straight)
    segment.form.straight = 0.5;
  return segment.form.inflection || segment.form.straight;
}

/// True if the shape of a law is almost that of another one, such as a line.
bool is_degenerate(const LawForm& form) {
  constexpr double most_straight = 0.9;
  constexpr double least_inflection = 0.1;
  return form.straight.value_or(0) > most_straight ||
         std::abs(form.inflection.value_or(0.5) - 0.5) > 0.5 - least_inflection;
}

void add_form(std::vector<Parameter>& all, const CamSpec& spec, std::size_t segment) {
  const LawForm& form = spec.segments[segment].form;
  if (form.inflection) all.push_back({Parameter::Kind::inflection, {segment}, 1});
  if (form.straight) all.push_back({Parameter::Kind::straight, {segment}, 1});
}

class Fitter {
 public:
  explicit Fitter(const MeasuredCam& measured) : measured_(measured) { lay_out(); }

  CamFit run() {
    if (!by_parts()) spec_ = cam_detail::one_spline(measured_), found_.assign(1, {});
    cam_detail::round_values(spec_, everything(), measured_);
    align_lines();
    return result();
  }

 private:
  /// The state of a segment.
  struct Found {
    bool settled = false;
    std::optional<Law> next = {};
    double next_worst = 0;
  };

  [[nodiscard]] Law law(std::size_t segment) const { return spec_.segments[segment].law; }
  [[nodiscard]] const CamKnot& knot(std::size_t number) const {
    return cam_detail::knot(spec_, number);
  }
  [[nodiscard]] double master(std::size_t point) const { return measured_.points[point].master; }
  [[nodiscard]] double whole() const {
    return measured_.points.back().master - measured_.points.front().master;
  }

  bool by_parts();
  void lay_out();
  void append(Law law, double master, double slave);
  void insert(std::size_t at, CamSegment segment, const Found& found);
  void erase(std::size_t at);
  bool settle(std::size_t segment, int depth);
  bool try_laws(std::size_t segment, bool formed);
  bool split_at_line(std::size_t segment, int depth);
  void leave_out(std::size_t dwell);
  void join_motions(std::size_t dwell);
  void open_ends();
  void make_spline(std::size_t segment);
  void join_to_spline(double at);
  void align_lines();

  [[nodiscard]] std::vector<std::size_t> points_in(double from, double to) const;
  [[nodiscard]] std::vector<std::size_t> all_points() const {
    return points_in(-HUGE_VAL, HUGE_VAL);
  }
  [[nodiscard]] std::vector<std::size_t> points_near(std::size_t segment) const;
  [[nodiscard]] Stretch points_of(std::size_t segment) const;
  [[nodiscard]] std::vector<std::size_t> same_level(const CamSpec& spec, std::size_t number) const;
  void add_master(std::vector<Parameter>& all, std::size_t number) const;
  void add_slave(std::vector<Parameter>& all, const CamSpec& spec, std::size_t number) const;
  [[nodiscard]] std::vector<Parameter> beside(const CamSpec& spec, std::size_t segment) const;
  [[nodiscard]] std::vector<Parameter> everything() const;
  Deviation refine(CamSpec& spec, const std::vector<Parameter>& parameters,
                   const std::vector<std::size_t>& points) const {
    return cam_detail::refine(spec, parameters, measured_, points);
  }
  [[nodiscard]] Deviation deviation(const CamSpec& spec) const {
    return cam_detail::deviation(spec, measured_, all_points());
  }
  CamFit result();

  const MeasuredCam& measured_;
  CamSpec spec_;
  std::vector<Found> found_;  // one for each segment
  double stroke_ = 0;
  double advance_ = 0;  // change of the slave in a period
};

void Fitter::append(Law law, double master, double slave) {
  spec_.segments.push_back({.law = law, .end = {master, slave}});
  found_.push_back({.settled = is_straight(law)});
}

void Fitter::insert(std::size_t at, CamSegment segment, const Found& found) {
  const auto place = static_cast<std::ptrdiff_t>(at);
  spec_.segments.insert(spec_.segments.begin() + place, std::move(segment));
  found_.insert(found_.begin() + place, found);
}

void Fitter::erase(std::size_t at) {
  spec_.segments.erase(spec_.segments.begin() + static_cast<std::ptrdiff_t>(at));
  found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(at));
}

/// Finds the laws of all parts. Returns false if the cam leaves a tolerance, or if the parts cannot
/// be joined.
bool Fitter::by_parts() {
  try {
    for (std::size_t i = spec_.segments.size(); i-- > 0;)
      if (!is_straight(law(i))) settle(i, 0);
    for (std::size_t i = spec_.segments.size(); i-- > 0;)
      if (i < spec_.segments.size() && law(i) == Law::dwell) leave_out(i);
    for (std::size_t i = spec_.segments.size(); i-- > 0;)
      if (i < spec_.segments.size() && law(i) == Law::dwell) join_motions(i);
    open_ends();
    for (std::size_t i = 0; i < spec_.segments.size(); ++i)
      if (!found_[i].settled) make_spline(i);
    for (std::size_t tries = spec_.segments.size(); tries > 1; --tries) {
      const Deviation now = refine(spec_, everything(), all_points());
      const auto between = cam_detail::oscillation(spec_, measured_, all_points());
      if (now.fits() && !between) return true;
      join_to_spline(now.fits() ? *between : master(now.where));
    }
  } catch (const InputError&) {  // from design(): a derivative at a knot contradicts a law
    return false;
  }
  return refine(spec_, everything(), all_points()).fits();
}

/// Makes the segment at a master position and one beside it a spline; a spline, if there is one.
void Fitter::join_to_spline(double at) {
  std::size_t i = 0;
  while (i + 1 < spec_.segments.size() && at > knot(i + 1).master) ++i;
  const bool with_next =
      i + 1 < spec_.segments.size() && (i == 0 || is_spline(law(i + 1)) || !is_spline(law(i - 1)));
  if (!with_next) --i;
  spec_.segments[i] = {.law = Law::quintic, .end = spec_.segments[i + 1].end};
  found_[i] = {};
  erase(i + 1);
  make_spline(i);
}

/// Makes the first spec: dwells, and quintics between them.
void Fitter::lay_out() {
  const auto& points = measured_.points;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.slave < b.slave; });
  stroke_ = std::max(high->slave - low->slave, points.front().tolerance);
  spec_.periodic = measured_.periodic;
  const double travel = points.back().slave - points.front().slave;
  if (measured_.periodic && std::abs(travel) > points.front().tolerance + points.back().tolerance)
    advance_ = travel;
  const std::vector<Stretch> rests = cam_detail::rests(measured_);
  const bool rests_first = !rests.empty() && rests.front().first == 0;
  const bool rests_last = !rests.empty() && rests.back().last + 1 == points.size();
  double first = rests_first ? cam_detail::level(measured_, rests.front()) : points.front().slave;
  double last = rests_last ? cam_detail::level(measured_, rests.back()) : points.back().slave;
  if (measured_.periodic) {  // one knot
    const double middle = (first + last - advance_) / 2;
    first = middle;
    last = middle + advance_;
  }
  spec_.start = {points.front().master, first};
  for (const Stretch& rest : rests) {
    const bool to_end = rest.last + 1 == points.size();
    const double at = rest.first == 0 ? first : to_end ? last : cam_detail::level(measured_, rest);
    double from = master(rest.first), to = master(rest.last);
    if (rest.first == rest.last) {  // a reversal between two points
      from = (master(rest.first - 1) + from) / 2;
      to = (to + master(rest.last + 1)) / 2;
    }
    if (rest.first > 0) append(Law::quintic, from, at);
    append(Law::dwell, to, at);
  }
  if (!rests_last) append(Law::quintic, points.back().master, last);
  if (advance_ != 0) spec_.slave_period = std::abs(advance_);
}

std::vector<std::size_t> Fitter::points_in(double from, double to) const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < measured_.points.size(); ++i)
    if (master(i) >= from && master(i) <= to) all.push_back(i);
  return all;
}

/// Points of a segment, and of the nearer halves of straight segments beside it.
std::vector<std::size_t> Fitter::points_near(std::size_t i) const {
  const auto middle = [&](std::size_t k) { return (knot(k).master + knot(k + 1).master) / 2; };
  const bool before = i > 0 && is_straight(law(i - 1));
  const bool after = i + 1 < spec_.segments.size() && is_straight(law(i + 1));
  return points_in(before ? middle(i - 1) : knot(i).master,
                   after ? middle(i + 1) : knot(i + 1).master);
}

/// First and last point of a segment.
Stretch Fitter::points_of(std::size_t i) const {
  const auto inside = points_in(knot(i).master, knot(i + 1).master);
  if (inside.empty()) return {};
  return {inside.front(), inside.back()};
}

/// Knots whose slave position changes with that of a knot: those at the ends of dwells, and the two
/// ends of a periodic cam.
std::vector<std::size_t> Fitter::same_level(const CamSpec& spec, std::size_t number) const {
  const std::size_t last = spec.segments.size();
  std::vector<bool> is_same(last + 1, false);
  std::vector<std::size_t> all;
  std::vector<std::size_t> open{number};
  while (!open.empty()) {
    const std::size_t k = open.back();
    open.pop_back();
    if (is_same[k]) continue;
    is_same[k] = true;
    all.push_back(k);
    if (k > 0 && spec.segments[k - 1].law == Law::dwell) open.push_back(k - 1);
    if (k < last && spec.segments[k].law == Law::dwell) open.push_back(k + 1);
    if (spec.periodic && (k == 0 || k == last)) open.push_back(last - k);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void Fitter::add_master(std::vector<Parameter>& all, std::size_t number) const {
  if (number == 0 || number >= spec_.segments.size()) return;
  all.push_back({Parameter::Kind::master, {number}, whole()});
}

void Fitter::add_slave(std::vector<Parameter>& all, const CamSpec& spec, std::size_t number) const {
  const auto level = same_level(spec, number);
  const bool known = std::any_of(all.begin(), all.end(), [&](const Parameter& p) {
    return p.kind == Parameter::Kind::slave && p.at.front() == level.front();
  });
  if (!known) all.push_back({Parameter::Kind::slave, level, stroke_});
}

/// The knots of a segment that may move: those beside straight segments.
std::vector<Parameter> Fitter::beside(const CamSpec& spec, std::size_t i) const {
  std::vector<Parameter> all;
  const bool before = i == 0 || is_straight(spec.segments[i - 1].law);
  const bool after = i + 1 == spec.segments.size() || is_straight(spec.segments[i + 1].law);
  if (before) {
    if (i > 0) add_master(all, i);
    add_slave(all, spec, i);
  }
  if (after) {
    if (i + 1 < spec.segments.size()) add_master(all, i + 1);
    add_slave(all, spec, i + 1);
  }
  add_form(all, spec, i);
  return all;
}

/// Every number of the spec that a spline does not depend on.
std::vector<Parameter> Fitter::everything() const {
  std::vector<Parameter> all;
  const auto by_spline = [&](std::size_t k) {
    return (k > 0 && is_spline(law(k - 1))) || (k < spec_.segments.size() && is_spline(law(k)));
  };
  for (std::size_t k = 0; k <= spec_.segments.size(); ++k) {
    const auto level = same_level(spec_, k);
    if (!by_spline(k)) add_master(all, k);
    if (std::none_of(level.begin(), level.end(), by_spline)) add_slave(all, spec_, k);
    if (by_spline(k) || (k > 0 && k == spec_.segments.size() && spec_.periodic)) continue;
    std::vector<std::size_t> at{k};
    if (k == 0 && spec_.periodic) at.push_back(spec_.segments.size());
    if (knot(k).geo_velocity) all.push_back({Parameter::Kind::geo_velocity, at, stroke_ / whole()});
    if (knot(k).geo_acceleration)
      all.push_back({Parameter::Kind::geo_acceleration, at, stroke_ / whole() / whole()});
  }
  for (std::size_t i = 0; i < spec_.segments.size(); ++i) add_form(all, spec_, i);
  return all;
}

/// Finds the law of a motion; if there is none, divides it at a straight line. Returns true if it
/// finds a law.
bool Fitter::settle(std::size_t i, int depth) {
  constexpr int most_depth = 3;
  return try_laws(i, false) || try_laws(i, true) || (depth < most_depth && split_at_line(i, depth));
}

/// Takes the law with the least rms distance, if its greatest distance is within the tolerances.
/// The slave rests, or moves at constant velocity, before and after the motion. `formed`: the
/// parameters of the law's shape are found, too.
bool Fitter::try_laws(std::size_t i, bool formed) {
  const auto points = points_near(i);
  struct Trial {
    CamSpec spec;
    Deviation deviation;
  };
  std::optional<Trial> best, second;
  for (const LawInfo& candidate : all_laws()) {
    if (!is_candidate(candidate)) continue;
    Trial trial{spec_, {}};
    trial.spec.segments[i].law = candidate.law;
    if (formed && !give_form(trial.spec.segments[i])) continue;
    trial.deviation = refine(trial.spec, beside(trial.spec, i), points);
    if (is_degenerate(trial.spec.segments[i].form)) continue;
    if (!best || trial.deviation.rms < best->deviation.rms) {
      second = std::exchange(best, std::move(trial));
    } else if (!second || trial.deviation.rms < second->deviation.rms) {
      second = std::move(trial);
    }
  }
  if (!best || !best->deviation.fits()) return false;
  spec_ = std::move(best->spec);
  found_[i] = {.settled = true};
  if (second) {
    found_[i].next = second->spec.segments[i].law;
    found_[i].next_worst = second->deviation.worst;
  }
  return true;
}

/// Makes the longest line in a motion a segment, and settles the parts beside it. Returns false,
/// and changes nothing, if no law fits either part.
bool Fitter::split_at_line(std::size_t i, int depth) {
  constexpr double least_line = 0.1;   // share of the motion, if laws fit all other parts
  constexpr double least_alone = 0.3;  // otherwise
  constexpr std::size_t near_end = 2;  // points beside the line that are no segment of their own
  const Stretch within = points_of(i);
  const auto line = cam_detail::longest_line(measured_, within, least_line);
  if (!line) return false;
  const CamSpec spec = spec_;
  const std::vector<Found> found = found_;
  const auto end_at = [&](std::size_t point) {
    return CamKnot{master(point), measured_.points[point].slave};
  };
  const bool before = line->first > within.first + near_end;
  const bool after = line->last + near_end < within.last;
  const auto straight = [&](std::size_t k) { return k < found_.size() && is_straight(law(k)); };
  if ((!before && i > 0 && straight(i - 1)) || (!after && straight(i + 1))) return false;
  std::size_t at = i;  // index of the line
  if (before) insert(at++, {.law = Law::quintic, .end = end_at(line->first)}, {});
  if (after)
    insert(at, {.law = Law::line, .end = end_at(line->last)}, {.settled = true});
  else
    spec_.segments[at].law = Law::line, found_[at].settled = true;
  bool any = !before && !after;
  if (after) any = settle(at + 1, depth + 1) || any;
  const std::size_t count = spec_.segments.size();
  if (before) any = settle(i, depth + 1) || any;
  at += spec_.segments.size() - count;
  const double share =
      (knot(at + 1).master - knot(at).master) / (master(within.last) - master(within.first));
  const bool all = std::all_of(
      found_.begin() + static_cast<std::ptrdiff_t>(i),
      found_.begin() + static_cast<std::ptrdiff_t>(i + 1 + found_.size() - found.size()),
      [](const Found& f) { return f.settled; });
  if (any && share >= (all ? least_line : least_alone)) return true;
  spec_ = spec;
  found_ = found;
  return false;
}

/// Leaves out a dwell that the points do not need: the slave reverses there, or does not stop.
void Fitter::leave_out(std::size_t i) {
  constexpr double longest = 0.1;       // share of the cam: a longer dwell stays
  constexpr double greater_rms = 1.05;  // by which the rms distance may increase
  constexpr double more_rms = 0.02;
  if (knot(i + 1).master - knot(i).master > longest * whole()) return;
  const bool first = i == 0, last = i + 1 == spec_.segments.size();
  if (spec_.segments.size() == 1 || (!first && !found_[i - 1].settled) ||
      (!last && !found_[i + 1].settled))
    return;
  std::vector<std::size_t> points = points_near(i);
  const auto add = [&](std::size_t segment) {
    const auto more = points_near(segment);
    points.insert(points.end(), more.begin(), more.end());
  };
  if (!first) add(i - 1);
  if (!last) add(i + 1);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const Deviation before = cam_detail::deviation(spec_, measured_, points);
  const CamSpec spec = spec_;
  const std::vector<Found> found = found_;
  const double middle = (knot(i).master + knot(i + 1).master) / 2;
  if (last) {
    spec_.segments[i - 1].end = spec_.segments[i].end;
  } else if (!first) {
    spec_.segments[i - 1].end.master = middle;
  }
  erase(i);
  std::vector<Parameter> parameters;
  const auto free = [&](std::size_t k) {
    add_master(parameters, k);
    add_slave(parameters, spec_, k);
  };
  for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, spec_.segments.size()); ++k) free(k);
  const Deviation after = refine(spec_, parameters, points);
  if (after.fits() && after.rms <= greater_rms * before.rms + more_rms) return;
  spec_ = spec;
  found_ = found;
}

/// Joins two motions without a law, if the slave only reverses between them.
void Fitter::join_motions(std::size_t i) {
  constexpr double longest = 0.02;  // share of the cam: a longer dwell stays
  if (i == 0 || i + 1 == spec_.segments.size()) return;
  if (found_[i - 1].settled || found_[i + 1].settled) return;
  if (knot(i + 1).master - knot(i).master > longest * whole()) return;
  spec_.segments[i - 1].end = spec_.segments[i + 1].end;
  erase(i + 1);
  erase(i);
}

/// Tries a quintic at an end of the points at which the slave moves.
void Fitter::open_ends() {
  const std::size_t last = spec_.segments.size() - 1;
  const auto open = [&](std::size_t k) { return !found_[k == 0 ? 0 : last].settled; };
  for (const std::size_t k : {std::size_t{0}, last + 1}) {
    if (!open(k) || (k > 0 && spec_.periodic && open(0))) continue;
    CamSpec trial = spec_;
    std::vector<std::size_t> ends{k};
    if (spec_.periodic) ends = {0, last + 1};
    std::vector<Parameter> parameters;
    std::vector<std::size_t> points;
    for (const std::size_t end : ends) {
      const std::size_t segment = end == 0 ? 0 : last;
      cam_detail::knot(trial, end).geo_velocity = 0;
      cam_detail::knot(trial, end).geo_acceleration = 0;
      trial.segments[segment].law = Law::quintic;
      for (const std::size_t i : points_near(segment))
        if (points.empty() || i > points.back()) points.push_back(i);
      for (const Parameter& p : beside(trial, segment)) {
        const bool known = std::any_of(parameters.begin(), parameters.end(), [&](const auto& q) {
          return q.kind == p.kind && q.at == p.at;
        });
        if (!known) parameters.push_back(p);
      }
    }
    parameters.push_back({Parameter::Kind::geo_velocity, ends, stroke_ / whole()});
    parameters.push_back({Parameter::Kind::geo_acceleration, ends, stroke_ / whole() / whole()});
    if (!refine(trial, parameters, points).fits()) continue;
    spec_ = std::move(trial);
    for (const std::size_t end : ends) found_[end == 0 ? 0 : last].settled = true;
  }
}

void Fitter::make_spline(std::size_t i) {
  if (spec_.periodic && (i == 0 || i + 1 == spec_.segments.size()) && !spec_.start.geo_velocity &&
      !is_straight(law(i)))
    cam_detail::close_with_spline(spec_, measured_);
  cam_detail::spline_part(spec_, i, measured_);
  found_[i] = {true};
}

/// Gives the lines at the start and at the end of a period one slope: they are one line.
void Fitter::align_lines() {
  const std::size_t last = spec_.segments.size() - 1;
  if (!spec_.periodic || last == 0 || law(0) != Law::line || law(last) != Law::line) return;
  const Deviation before = deviation(spec_);
  const auto& start = spec_.start;
  const auto& end = spec_.segments[last].end;
  const double slope = (knot(1).slave - start.slave) / (knot(1).master - start.master);
  const int first = cam_detail::first_decimal(stroke_ / whole());
  for (int d = first; d <= first + cam_detail::most_decimals; ++d) {
    CamSpec trial = spec_;
    const double rounded = cam_detail::with_decimals(slope, d);
    CamKnot& from = cam_detail::knot(trial, 1);
    CamKnot& to = cam_detail::knot(trial, last);
    from.slave = start.slave + rounded * (from.master - start.master);
    to.slave = end.slave - rounded * (end.master - to.master);
    if (!cam_detail::is_as_good(deviation(trial), before) && d < first + cam_detail::most_decimals)
      continue;
    spec_ = std::move(trial);
    return;
  }
}

CamFit Fitter::result() {
  CamFit fit;
  fit.spec = spec_;
  if (advance_ != 0)
    fit.spec.slave_period = std::abs(knot(spec_.segments.size()).slave - spec_.start.slave);
  const Cam cam = design(fit.spec).cam;
  std::size_t i = 0;
  fit.segments.resize(spec_.segments.size());
  for (const SplinePoint& p : measured_.points) {
    while (i + 1 < fit.segments.size() && p.master > knot(i + 1).master) ++i;
    const Side side = p.master > cam.start() ? Side::left : Side::right;
    const double gap = std::abs(cam.jet(p.master, side)[0] - p.slave);
    fit.segments[i].gap = std::max(fit.segments[i].gap, gap);
    if (gap > fit.gap) fit.gap = gap, fit.where = p.master;
    if (gap > p.tolerance * (1 + profiles_detail::rounded_input))
      fit.excess = std::max(fit.excess, gap - p.tolerance);
  }
  for (std::size_t k = 0; k < found_.size(); ++k) {
    fit.segments[k].next = found_[k].next;
    fit.segments[k].next_gap = found_[k].next_worst * measured_.points.front().tolerance;
  }
  return fit;
}

}  // namespace

CamFit fit_cam(const MeasuredCam& measured) {
  require_measured(measured);
  return Fitter(measured).run();
}

}  // namespace jounce
