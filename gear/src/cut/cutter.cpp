// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/cutter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "jounce/profiles/curve/between.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/profiles/error.hpp"

#include "gear/src/cut/knife_parts.hpp"
#include "gear/src/cut/line_bounds.hpp"
#include "gear/src/ratio/rest_to_rest.hpp"

// The motion from a cut to the next one over the length L has three parts:
//
//     (1)  head over c:  a fixed motion after the cut: the sync zone, and the braking of a shear
//     (2)  middle over m = L - c - t:  the recovery of a knife, the return of a shear
//     (3)  tail over t:  a fixed motion before the next cut: the sync zone, or the run-up of a shear
//
// Only the middle depends on L. From home, a shear begins with its tail. A knife begins in the
// middle of the longest recovery Lcrit, where its speed and acceleration are 0, and likewise ends.

namespace jounce {

using gear_detail::change;
using gear_detail::Knife;
using gear_detail::KnifeShape;
using gear_detail::least_factor;
using gear_detail::permits;
using gear_detail::speed_of;
using gear_detail::stretched;
using profiles_detail::rounded_input;

struct Cutter::Shape {
  Cam head;                                 // from 0
  Cam tail;                                 // up to 0
  std::optional<KnifeShape> recovery = {};  // recovery of a knife, in rad
  double recovery_start = 0;                // rad
  double unit = 1;                          // u per rad
  std::vector<Segment> back = {};           // return of a shear, over the length 1
  std::vector<double> back_from = {};       // start of each of its segments
  double home_middle = 0;                   // m, middle part of the motion from and to home
  double way_home = 0;                      // m, the part of it that leads home
  double way_out = 0;                       // m, the part of it that leads from home to the tail
  double turn = 0;
  double home = 0;
  double sync_before = 0;
  double sync_after = 0;
  double shortest = 0;
  double longest = std::numeric_limits<double>::infinity();
  bool waits = false;  // waits at home if the piece is long enough

  [[nodiscard]] std::size_t pieces() const { return recovery ? recovery->pieces() : back.size(); }
  [[nodiscard]] double from(std::size_t i) const {
    return i == pieces() ? 1 : recovery ? recovery->from(i) : back_from[i];
  }
  [[nodiscard]] Segment piece(std::size_t i, double length) const {
    if (recovery) return scaled(recovery->piece(i, length, recovery_start), unit);
    Segment piece = back[i];
    piece.length = (from(i + 1) - from(i)) * length;
    return piece;
  }
};

namespace {

Cam joined_at(std::vector<Segment> segments, double start) {
  return Cam(std::move(segments), start, Extrapolation::hold);
}

/// The segments of a cam with this name, from the first one on.
std::vector<Segment> named_segments(const SyncCam& cam, std::initializer_list<const char*> names) {
  std::vector<Segment> all;
  for (std::size_t i = 0; i < cam.segments.size(); ++i)
    if (std::find(names.begin(), names.end(), cam.segments[i]) != names.end())
      all.push_back(cam.cam.segments()[i]);
  return all;
}

double length_of(const std::vector<Segment>& segments) {
  double length = 0;
  for (const Segment& segment : segments) length += segment.length;
  return length;
}

constexpr int grid_of_lengths = 64;

/// The least factor of the length of a return, so that it keeps the limits of the carriage while the
/// line changes its speed.
double return_factor(const std::vector<Segment>& back, const CutLine& line) {
  if (!(line.rates.acceleration > 0 || line.rates.jerk > 0)) return 1;
  return least_factor(
      [&](double factor) { return speed_of(stretched(back, factor, 1), line) >= line.speed; });
}

}  // namespace

Cutter::Cutter(const CutMachine& machine, const CutLine& line) {
  const auto knife_shape = [](RotaryKnifeSpec spec) {
    spec.cut_length = std::numbers::pi * spec.diameter / static_cast<double>(spec.blades) /
                      spec.speed_ratio;  // always longer than the sync zone
    const Knife knife = gear_detail::knife_of(spec);
    const gear_detail::KnifeZone zone = gear_detail::zone_of(knife, spec);
    std::vector<Segment> head = zone.leaving;
    std::vector<Segment> tail = zone.entering(0);
    for (auto* part : {&head, &tail})
      for (Segment& segment : *part) segment = scaled(segment, knife.unit);
    Shape shape{.head = joined_at(std::move(head), 0),
                .tail = joined_at(std::move(tail), -knife.sync.length)};
    shape.recovery = knife.shape;
    shape.recovery_start = knife.sync.angle;
    shape.unit = knife.unit;
    shape.home_middle = knife.shape.longest();
    shape.way_home = shape.way_out = shape.home_middle / 2;
    shape.turn = spec.turn / static_cast<double>(spec.blades);
    shape.home = shape.turn / 2;
    shape.sync_before = shape.sync_after = knife.sync.length;
    shape.shortest = 2 * knife.sync.length;
    shape.waits = spec.dwell;
    if (!spec.dwell) shape.longest = knife.longest() * (1 + rounded_input);
    return shape;
  };
  const auto shear_shape = [&line](FlyingShear spec) {
    if (!spec.sync_time && !spec.sync_length)
      throw InputError("sync_time", "",
                       "is missing: give sync_time or sync_length. Without them, the sync depends "
                       "on the cut length, and each piece would need another cam");
    const ShearBound least = least_cut_length(spec);
    if (std::isfinite(least.value)) spec.cut_length = least.value;
    const SyncCam cam = flying_shear(spec);  // throws if no length is possible
    const ShearPlan plan = shear_plan(spec);
    std::vector<Segment> tail = named_segments(cam, {"accelerate"});
    std::vector<Segment> back = named_segments(cam, {"return"});
    const double run_up = length_of(tail);
    double way_home = length_of(back);
    Shape shape{.head = joined_at(named_segments(cam, {"sync", "decelerate"}), 0),
                .tail = joined_at(std::move(tail), -run_up)};
    for (double at = 0; const Segment& segment : back)
      shape.back_from.push_back(std::exchange(at, at + segment.length) / way_home);
    if (const double factor = spec.return_length ? 1 : return_factor(back, line);
        std::isfinite(factor))
      way_home *= factor;
    shape.back = std::move(back);
    shape.home_middle = shape.way_home = way_home;
    shape.sync_after = plan.sync;
    shape.shortest = shape.tail.length() + shape.head.length() + way_home;
    shape.waits = spec.return_length.has_value();
    return shape;
  };
  shape_ = std::make_unique<const Shape>(std::holds_alternative<FlyingShear>(machine)
                                             ? shear_shape(std::get<FlyingShear>(machine))
                                             : knife_shape(std::get<RotaryKnifeSpec>(machine)));
}

Cutter::~Cutter() = default;
Cutter::Cutter(Cutter&&) noexcept = default;
Cutter& Cutter::operator=(Cutter&&) noexcept = default;

double Cutter::approach() const {
  return shape_->way_out + shape_->tail.length();
}
double Cutter::retreat() const {
  return shape_->head.length() + shape_->way_home;
}
double Cutter::commit() const {
  return shape_->head.length();
}
double Cutter::sync_before() const {
  return shape_->sync_before;
}
double Cutter::sync_after() const {
  return shape_->sync_after;
}
double Cutter::turn() const {
  return shape_->turn;
}
double Cutter::home() const {
  return shape_->home;
}
double Cutter::shortest() const {
  return shape_->shortest;
}
double Cutter::longest() const {
  return shape_->longest;
}

bool Cutter::links(double length) const {
  const bool returns = length >= approach() + retreat();
  return shape_->recovery ? !returns : !(returns && shape_->waits);
}

// ---- motions -----------------------------------------------------------------------------------

/// The middle part over `length`, at `at` from its start.
Jet Cutter::middle(double length, double at) const {
  const double x = std::clamp(at, 0.0, length);
  std::size_t i = 0;
  while (i + 1 < shape_->pieces() && shape_->from(i + 1) * length <= x) ++i;
  const Segment piece = shape_->piece(i, length);
  return evaluate(piece, std::clamp((x - shape_->from(i) * length) / piece.length, 0.0, 1.0));
}

Jet Cutter::approach(double at) const {
  const double t = shape_->tail.length();
  if (at >= -t) return shape_->tail.jet(std::min(at, 0.0), at < 0 ? Side::right : Side::left);
  Jet y{shape_->home - shape_->turn, 0, 0, 0};
  if (at > -approach()) {
    y = middle(shape_->home_middle, shape_->home_middle + at + t);
    y[0] -= shape_->turn;
  }
  return y;
}

Jet Cutter::retreat(double at) const {
  const double c = shape_->head.length();
  if (at < c) return shape_->head.jet(std::max(at, 0.0));
  if (at < retreat()) return middle(shape_->home_middle, at - c);
  return {shape_->home, 0, 0, 0};
}

Jet Cutter::link(double length, double at) const {
  const double c = shape_->head.length();
  const double t = shape_->tail.length();
  if (at < c) return shape_->head.jet(std::max(at, 0.0));
  if (at < length - t) return middle(length - c - t, at - c);
  Jet y = approach(at - length);
  y[0] += shape_->turn;
  return y;
}

// ---- segments ----------------------------------------------------------------------------------

namespace {

void add(Cutter::Parts& to, std::span<const Segment> segments, double offset, const char* name) {
  for (const Segment& segment : segments) {
    to.segments.push_back(scaled(segment, 1, offset));
    to.names.emplace_back(name);
  }
}

}  // namespace

void Cutter::add_middle(Parts& to, double length, double from, double until, double offset,
                        const char* name) const {
  std::vector<Segment> all;
  for (std::size_t i = 0; i < shape_->pieces(); ++i) all.push_back(shape_->piece(i, length));
  const Cam whole(std::move(all), 0, Extrapolation::hold);
  const bool entire = from == 0 && until == length;
  add(to, entire ? whole.segments() : between(whole, from, until).segments(), offset, name);
}

void Cutter::add_approach(Parts& to, double offset) const {
  const double m = shape_->home_middle;
  const bool knife = shape_->recovery.has_value();
  if (knife) add_middle(to, m, m - shape_->way_out, m, offset - shape_->turn, "start");
  add(to, shape_->tail.segments(), offset, knife ? "sync" : "accelerate");
}

/// The head: of a shear, its sync zone and its braking.
namespace {
void add_head(Cutter::Parts& to, const Cam& head, double sync, double offset) {
  for (std::size_t i = 0; i < head.segments().size(); ++i)
    add(to, head.segments().subspan(i, 1), offset,
        head.breaks()[i + 1] <= sync * (1 + rounded_input) ? "sync" : "decelerate");
}
}  // namespace

void Cutter::add_retreat(Parts& to, double offset) const {
  add_head(to, shape_->head, shape_->sync_after, offset);
  add_middle(to, shape_->home_middle, 0, shape_->way_home, offset,
             shape_->recovery ? "stop" : "return");
}

void Cutter::add_piece(Parts& to, double length, double offset) const {
  if (links(length)) {
    const double m = length - shape_->head.length() - shape_->tail.length();
    const bool knife = shape_->recovery.has_value();
    add_head(to, shape_->head, shape_->sync_after, offset);
    add_middle(to, m, 0, m, offset, knife ? "recovery" : "return");
    add(to, shape_->tail.segments(), offset + shape_->turn, knife ? "sync" : "accelerate");
    return;
  }
  add_retreat(to, offset);
  const double rest = length - approach() - retreat();
  const double home = shape_->home + offset;
  if (rest > 0) {
    const Segment stand = line(rest, home, home);
    add(to, std::span(&stand, 1), 0, "wait");
  }
  add_approach(to, offset + shape_->turn);
}

std::vector<CutRange> possible_lengths(const Cutter& cutter, const CutLine& line) {
  require_positive("line_speed", line.speed);
  const double home = cutter.approach() + cutter.retreat();
  const double least = line.speed * (1 - rounded_input);
  const auto can = [&](double length) {
    Cutter::Parts parts;
    cutter.add_piece(parts, length, 0);
    return permits(std::move(parts.segments), line);
  };
  Cutter::Parts from_home;
  cutter.add_approach(from_home, 0);
  Cutter::Parts to_home;
  cutter.add_retreat(to_home, 0);
  const double fastest = std::min(speed_of(std::move(from_home.segments), line),
                                  speed_of(std::move(to_home.segments), line));
  const bool shear = !(cutter.turn() > 0);
  if (!(fastest >= least))
    throw InputError(
        "line_speed", line.speed,
        "must be at most " + six_digits_down(fastest) + (shear ? " with this cam" : "") +
            ": above this speed of the line, the way from home to a cut and back exceeds a limit "
            "of the slave" +
            (shear ? ". Or lengthen this way: give a greater safety and return_length" : ""));
  if (shear) return {{cutter.shortest()}};  // the bound of its plan
  std::vector<double> lengths;
  const double low = cutter.shortest() * (1 + rounded_input);
  for (int i = 0; i <= grid_of_lengths; ++i)
    lengths.push_back(low + (home - low) * i / grid_of_lengths);
  std::vector<CutRange> ranges;
  bool before = can(lengths.front());
  if (before) ranges.push_back({lengths.front()});
  for (std::size_t i = 1; i < lengths.size(); ++i) {
    const bool now = can(lengths[i]);
    if (now == before) continue;
    const double at = change(lengths[i - 1], lengths[i], can);
    if (now)
      ranges.push_back({at});
    else
      ranges.back().to = at;
    before = now;
  }
  ranges.back().to = cutter.longest();  // at `home` and above, the piece is possible
  return ranges;
}

}  // namespace jounce
