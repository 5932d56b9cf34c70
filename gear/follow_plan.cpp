#include "jounce/gear/follow_plan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/gear/detail/follow_passes.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/extrema.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

// From ratio r0 to r1 over the master's length L the slave is to travel S. One segment of linear
// ratio does where
//
//   (1)  S = (r0 + r1) L / 2.
//
// Two, of lengths a and b = L - a, that meet at the ratio r have S = (r0 + r) a / 2 + (r + r1) b / 2:
//
//   (2)  r = (2 S - r0 a - r1 b) / L       for any a.
//
// The greater slope is least where both are k and -k, r - r0 = k a and r - r1 = k b, so that with
// w = r1 - r0, D = S - (r0 + r1) L / 2:  a = (L + w / k) / 2  and  D = k L^2 / 4 - w^2 / (4 k), hence
//
//   (3)  k = (2 D + sign(D) sqrt(4 D^2 + w^2 L^2)) / L^2,     |w / k| <= L.
//
// Where r has the other sign than r0, r1 and S, the slave would run backwards. Then it falls to rest
// with the slope k in a = |r0| / k, stands, and leaves with it in b = |r1| / k:
//
//   (4)  k = (r0^2 + r1^2) / (2 |S|),      a + b < L, for k is above that of (3).
//
// With a and b rounded down to whole master units the part between runs on at a ratio c:
//
//   (5)  c = (2 S - r0 a - r1 b) / (2 L - a - b).

namespace jounce {
namespace {

using detail::rounded;

constexpr double rounding = 1e-9;

/// A place where the slave's position and ratio are known; `zone` leads to it in step.
struct Knot {
  double master = 0;
  double slave = 0;
  std::optional<double> ratio = {};
  std::optional<std::size_t> zone = {};
};

std::string key(const char* list, std::size_t i, const char* name) {
  return std::string(list) + "[" + std::to_string(i + 1) + "]." + name;
}

bool near(double a, double b) {
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

/// A sync point or a zone, by its place.
struct Item {
  double master = 0;
  bool is_zone = false;
  std::size_t index = 0;
};

class Knots {
 public:
  explicit Knots(const FollowPlan& plan) : plan_(plan) {
    require_numbers();
    all_.push_back({0, 0, plan.start_ratio, {}});
    if (!plan.start_ratio && !begins_in_step()) all_[0].ratio = 0;
    const auto items = sorted();
    for (const Item& item : items) item.is_zone ? add_zone(item.index) : add_point(item.index);
    if (all_.size() < 2)
      throw InputError("point", "none", "there must be a sync point or a zone after the start");
    close();
    fill();
  }

  [[nodiscard]] std::vector<Knot> all() && { return std::move(all_); }

 private:
  void require_numbers() const {
    if (plan_.start_ratio) require_finite("start_ratio", *plan_.start_ratio);
    for (std::size_t i = 0; i < plan_.points.size(); ++i) {
      const FollowPoint& p = plan_.points[i];
      require_finite(key("point", i, "master").c_str(), p.master);
      require_finite(key("point", i, "slave").c_str(), p.slave);
      require_finite(key("point", i, "ratio").c_str(), p.ratio.value_or(0));
      if (i > 0 && !(p.master > plan_.points[i - 1].master))
        throw InputError(
            key("point", i, "master"), p.master,
            "must be greater than " + number(plan_.points[i - 1].master) + ", the point before");
    }
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      const FollowZone& z = plan_.zones[i];
      require_finite(key("zone", i, "from").c_str(), z.from);
      require_finite(key("zone", i, "to").c_str(), z.to);
      require_finite(key("zone", i, "ratio").c_str(), z.ratio);
      require_finite(key("zone", i, "slave").c_str(), z.slave.value_or(0));
      if (!(z.to > z.from))
        throw InputError(key("zone", i, "to"), z.to, "must be greater than " + number(z.from));
      if (i > 0 && !(z.from >= plan_.zones[i - 1].to))
        throw InputError(
            key("zone", i, "from"), z.from,
            "must be at least " + number(plan_.zones[i - 1].to) + ", where the one before ends");
    }
  }

  [[nodiscard]] bool begins_in_step() const {
    return std::any_of(plan_.zones.begin(), plan_.zones.end(),
                       [](const FollowZone& z) { return z.from == 0; });
  }

  [[nodiscard]] bool in_zone(const FollowPoint& p) const {
    return std::any_of(plan_.zones.begin(), plan_.zones.end(),
                       [&](const FollowZone& z) { return p.master >= z.from && p.master <= z.to; });
  }

  [[nodiscard]] std::vector<Item> sorted() const {
    std::vector<Item> items;
    for (std::size_t i = 0; i < plan_.zones.size(); ++i)
      items.push_back({plan_.zones[i].from, true, i});
    for (std::size_t i = 0; i < plan_.points.size(); ++i)
      if (!in_zone(plan_.points[i])) items.push_back({plan_.points[i].master, false, i});
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.master < b.master; });
    return items;
  }

  void add_point(std::size_t i) {
    const FollowPoint& p = plan_.points[i];
    if (!(p.master > all_.back().master))
      throw InputError(key("point", i, "master"), p.master,
                       "must be greater than " + number(all_.back().master) +
                           ", where the start, a point or a zone is");
    all_.push_back({p.master, p.slave, p.ratio, {}});
  }

  void add_zone(std::size_t i) {
    const FollowZone& z = plan_.zones[i];
    Knot& before = all_.back();
    if (z.from < before.master)
      throw InputError(key("zone", i, "from"), z.from,
                       "must be at least " + number(before.master) + ", where the one before ends");
    const double slave = begin_of(i);
    if (z.from == before.master) {
      join(i, before, slave);
    } else {
      all_.push_back({z.from, slave, z.ratio, {}});
    }
    all_.push_back({z.to, slave + z.ratio * (z.to - z.from), z.ratio, i});
  }

  /// A zone that begins where the start is, or another zone ends.
  void join(std::size_t i, Knot& before, double slave) const {
    const double ratio = plan_.zones[i].ratio;
    if (!near(slave, before.slave))
      throw InputError(key("zone", i, "slave"), slave,
                       "must be " + number(before.slave) + ", where the slave is then");
    if (before.ratio && !near(*before.ratio, ratio))
      throw InputError(
          key("zone", i, "ratio"), ratio,
          "must be " + number(*before.ratio) + ", the ratio there: leave room to change it before");
    before.ratio = ratio;
  }

  /// Where the slave is when the zone begins.
  [[nodiscard]] double begin_of(std::size_t i) const {
    const FollowZone& z = plan_.zones[i];
    std::optional<double> slave = z.slave;
    for (std::size_t k = 0; k < plan_.points.size(); ++k) {
      const FollowPoint& p = plan_.points[k];
      if (p.master < z.from || p.master > z.to) continue;
      const double expected = p.slave - z.ratio * (p.master - z.from);
      const double scale = std::abs(p.slave) + std::abs(z.ratio * z.to);
      if (slave && std::abs(*slave - expected) > rounding * scale)
        throw InputError(key("point", k, "slave"), p.slave,
                         "must be " + number(*slave + z.ratio * (p.master - z.from)) +
                             ", where zone " + std::to_string(i + 1) + " leads");
      if (!slave) slave = expected;
    }
    if (slave) return *slave;
    const Knot& before = all_.back();
    if (!before.ratio && all_.size() > 1)
      throw InputError(key("zone", i, "slave"), "",
                       "is missing: give it, a sync point within the zone, or a ratio to the point "
                       "before");
    return before.slave + (before.ratio.value_or(z.ratio) + z.ratio) / 2 * (z.from - before.master);
  }

  /// The ends.
  void close() {
    Knot& first = all_.front();
    Knot& last = all_.back();
    if (!plan_.periodic) {
      if (!last.ratio) last.ratio = 0;
      return;
    }
    // A start that nobody chose takes the ratio with which the plan ends.
    if (!plan_.start_ratio && !begins_in_step() && last.ratio) first.ratio = last.ratio;
    if (!last.ratio) last.ratio = first.ratio;
    if (!near(*first.ratio, *last.ratio))
      throw InputError("periodic", "true",
                       "needs the ratio of its start, " + number(*first.ratio) +
                           ", at its end, where it is " + number(*last.ratio));
  }

  /// Ratios left out: between the mean ratios before and after, so that nothing overshoots.
  void fill() {
    for (std::size_t i = 1; i + 1 < all_.size(); ++i) {
      if (all_[i].ratio) continue;
      const double h0 = all_[i].master - all_[i - 1].master;
      const double h1 = all_[i + 1].master - all_[i].master;
      all_[i].ratio = detail::between_chords(h0, (all_[i].slave - all_[i - 1].slave) / h0, h1,
                                             (all_[i + 1].slave - all_[i].slave) / h1);
    }
  }

  const FollowPlan& plan_;
  std::vector<Knot> all_;
};

std::vector<Knot> knots_of(const FollowPlan& plan) {
  return Knots(plan).all();
}

/// What lies between two knots.
struct Gap {
  double length;  // L
  double travel;  // S
  double r0;
  double r1;
};

Gap gap(const Knot& a, const Knot& b) {
  return {b.master - a.master, b.slave - a.slave, *a.ratio, *b.ratio};
}

/// Whether a ratio is against both ends': 0 where those differ in sign, or are both 0.
int way(const Gap& g) {
  const bool forward = g.r0 >= 0 && g.r1 >= 0;
  const bool back = g.r0 <= 0 && g.r1 <= 0;
  if (forward && back) return g.travel > 0 ? 1 : (g.travel < 0 ? -1 : 0);
  return forward ? 1 : (back ? -1 : 0);
}

/// A piece of a gap: how long, how far, and whether it stands or runs evenly.
struct Piece {
  double length;
  double travel;
  PtType type = PtType::normal;
};

/// How the slave falls to rest, or to the ratio c, and leaves: (4), (5).
struct Rest {
  double a;
  double b;
  double c;
};

Rest rest_of(const Gap& g, bool whole) {
  const double k = (g.r0 * g.r0 + g.r1 * g.r1) / (2 * std::abs(g.travel));  // (4)
  const double a = std::abs(g.r0) / k;
  const double b = std::abs(g.r1) / k;
  // Of an end at rest a unit leads to the ratio c.
  const double p = a > 0 ? std::floor(a) : 1;
  const double q = b > 0 ? std::floor(b) : 1;
  if (!whole || p < 1 || q < 1 || p + q >= g.length) return {a, b, 0};
  return {p, q, (2 * g.travel - g.r0 * p - g.r1 * q) / (2 * g.length - p - q)};  // (5)
}

std::vector<Piece> resting(const Gap& g, bool whole) {
  const auto [a, b, c] = rest_of(g, whole);
  const double between = g.length - a - b;
  std::vector<Piece> pieces;
  if (a > 0) pieces.push_back({a, (g.r0 + c) / 2 * a});
  pieces.push_back({between, c * between, PtType::even});
  if (b > 0) pieces.push_back({b, (c + g.r1) / 2 * b});
  return pieces;
}

std::vector<Piece> pieces_of(const Gap& g, bool whole) {
  const double D = g.travel - (g.r0 + g.r1) * g.length / 2;
  const double scale = std::abs(g.travel) + (std::abs(g.r0) + std::abs(g.r1)) * g.length;
  if (std::abs(D) <= 1e-12 * scale) return {{g.length, g.travel}};  // (1)
  const double w = g.r1 - g.r0;
  const double k =
      (2 * D + std::copysign(std::hypot(2 * D, w * g.length), D)) / (g.length * g.length);  // (3)
  double a = (g.length + w / k) / 2;
  if (whole && g.length >= 2) a = std::clamp(std::round(a), 1.0, std::ceil(g.length) - 1);
  const double b = g.length - a;
  if (!(a > 0 && b > 0)) return {{g.length, g.travel}};  // one slope is all of it, to rounding
  const double r = (2 * g.travel - g.r0 * a - g.r1 * b) / g.length;  // (2)
  if (way(g) * r < 0 && way(g) * g.travel > 0) return resting(g, whole);
  const double first = (g.r0 + r) / 2 * a;
  return {{a, first}, {b, g.travel - first}};
}

}  // namespace

FollowTable follow_table(const FollowPlan& plan) {
  const auto knots = knots_of(plan);
  FollowTable table;
  table.loops = plan.periodic ? 0 : 1;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Knot& to = knots[i];
    if (to.zone) {
      table.segments.push_back({to.master, to.slave, PtType::even});
      continue;
    }
    const auto pieces = pieces_of(gap(knots[i - 1], to), plan.whole_master);
    PtPoint at{knots[i - 1].master, knots[i - 1].slave, PtType::normal};
    for (const Piece& piece : pieces)
      table.segments.push_back(at = {at.x + piece.length, at.position + piece.travel, piece.type});
    // What is known is met, not what rounding makes of the pieces; the end of a motion is exactly at rest.
    PtPoint& last = table.segments.back();
    last = {to.master, to.slave,
            *to.ratio == 0 && last.type == PtType::normal ? PtType::stop : last.type};
  }
  PtType& first = table.segments.front().type;
  if (first == PtType::normal && *knots.front().ratio != 0) first = PtType::continued;
  return table;
}

CamSpec cam_spec(const FollowPlan& plan) {
  const auto knots = knots_of(plan);
  // At a zone the line itself says the ratio: of far positions its own differs by their rounding.
  const auto in_step = [&](std::size_t i) {
    return knots[i].zone || (i + 1 < knots.size() && knots[i + 1].zone);
  };
  const bool seam = plan.periodic && (in_step(0) || in_step(knots.size() - 1));
  const auto cam_knot = [&](std::size_t i) {
    const Knot& k = knots[i];
    const bool end = i == 0 || i + 1 == knots.size();
    if (in_step(i) || (end && seam)) return CamKnot{k.master, k.slave, {}, 0.0};
    return CamKnot{k.master, k.slave, k.ratio, 0.0};
  };
  CamSpec spec;
  spec.start = cam_knot(0);
  spec.periodic = plan.periodic;
  const double travel = std::abs(knots.back().slave);
  if (plan.periodic && travel > 0) spec.slave_period = travel;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const Knot& k = knots[i];
    const bool stands =
        !k.zone && k.slave == knots[i - 1].slave && *k.ratio == 0 && *knots[i - 1].ratio == 0;
    const Law law = k.zone ? Law::line : (stands ? Law::dwell : plan.law);
    spec.segments.push_back({law, cam_knot(i), k.zone ? plan.zones[*k.zone].name : ""});
  }
  return spec;
}

namespace {

FollowSpec table_spec(const FollowPlan& plan) {
  return {{follow_table(plan)}, *knots_of(plan).front().ratio};
}

std::vector<SyncZone> zones_of(const FollowPlan& plan) {
  std::vector<SyncZone> zones;
  for (const FollowZone& z : plan.zones)
    zones.push_back({z.from, z.to, z.name.empty() ? "ratio " + rounded(z.ratio) : z.name});
  return zones;
}

SyncCam smooth(const FollowPlan& plan) {
  const CamSpec spec = cam_spec(plan);
  auto [cam, origin] = design(spec);
  std::vector<std::string> names;
  for (const std::size_t i : origin) {
    const CamSegment& segment = spec.segments[i];
    names.push_back((segment.name.empty() ? name(segment.law) : segment.name) +
                    (" to " + detail::place(segment.end.master)));
  }
  const bool starts_in_step = !plan.periodic && *knots_of(plan).front().ratio != 0;
  return {starts_in_step ? with(cam, Outside::refuse) : cam, std::move(names), zones_of(plan)};
}

/// The one gap as a cam of its own.
Cam gap_cam(const Gap& g, Law law) {
  CamSpec spec;
  spec.start = {0, 0, g.r0, 0.0};
  spec.segments = {{law, {g.length, g.travel, g.r1, 0.0}}};
  return design(spec).cam;
}

/// How fast the slave runs backwards in a gap, at the worst; 0 if it does not.
Extremum backwards_in(const Gap& g, const FollowPlan& plan) {
  const int s = way(g);
  if (s == 0 || (g.travel == 0 && g.r0 == 0 && g.r1 == 0)) return {};
  if (plan.form == FollowForm::table && s * g.travel > 0) return {};
  const Cam cam = plan.form == FollowForm::smooth ? gap_cam(g, plan.law) : [&] {
    std::vector<PtPoint> points;
    PtPoint at;
    for (const Piece& p : pieces_of(g, false))
      points.push_back(at = {at.x + p.length, at.position + p.travel, PtType::continued});
    return pt<OverMaster>(points, g.r0);
  }();
  const Range r = extrema(cam, 1);
  const Extremum& worst = s > 0 ? r.min : r.max;
  const bool against = -s * worst.value > rounding * std::abs(r.peak().value);
  return against ? worst : Extremum{};
}

/// The least travel with which the gap's law does not turn back: between what is asked for, which
/// does, and that of a straight ramp, which does not.
double least_travel(const Gap& g, const FollowPlan& plan) {
  if (plan.form == FollowForm::table) return 0;
  double bad = g.travel;
  double good = (g.r0 + g.r1) * g.length / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (bad + good) / 2;
    Gap tried = g;
    tried.travel = middle;
    (backwards_in(tried, plan).value != 0 ? bad : good) = middle;
  }
  return good;
}

std::string travel_advice(const Gap& g, const FollowPlan& plan, double from, double to) {
  const std::string where = "between master " + rounded(from) + " and " + rounded(to) +
                            " the slave travels " + rounded(g.travel);
  const double least = least_travel(g, plan);
  if (plan.form == FollowForm::table || way(g) * g.travel <= 0)
    return where + ", against its ratios there: give it the other sign, or a point where it turns";
  return where + "; from " + rounded(least) +
         " on it does not turn back: move a point, or let form = \"table\" stand in between";
}

/// Whether a table that should be at whole master units is.
void add_whole(Report& report, const FollowPlan& plan) {
  const auto segments = follow_table(plan).segments;
  const auto odd = std::find_if(segments.begin(), segments.end(),
                                [](const PtPoint& p) { return p.x != std::round(p.x); });
  if (!plan.whole_master || odd == segments.end()) return;
  Finding f;
  f.rule = "follow/whole_master";
  f.quantity = "the master's position";
  f.where = f.value = odd->x;
  f.limit = std::round(odd->x);
  f.margin = -std::abs(f.value - f.limit);
  f.broken = true;
  f.segment = static_cast<std::size_t>(odd - segments.begin());
  f.advice = "it is no whole number: put points and zones on whole ones, and leave room between";
  report.findings.push_back(std::move(f));
}

}  // namespace

SyncCam follow(const FollowPlan& plan) {
  if (plan.form == FollowForm::smooth) return smooth(plan);
  SyncCam made = follow(table_spec(plan));
  made.zones = zones_of(plan);
  return made;
}

Report check(const FollowPlan& plan) {
  Report report;
  if (plan.form == FollowForm::table) {
    report = check(table_spec(plan));
    add_whole(report, plan);
  }
  const auto knots = knots_of(plan);
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (knots[i].zone) continue;
    const Gap g = gap(knots[i - 1], knots[i]);
    const Extremum worst = backwards_in(g, plan);
    if (worst.value == 0) continue;
    Finding f;
    f.rule = "follow/backwards";
    f.quantity = "geo_velocity";
    f.where = knots[i - 1].master + worst.where;
    f.value = worst.value;
    f.margin =
        -std::abs(worst.value) / std::max({std::abs(g.r0), std::abs(g.r1), std::abs(worst.value)});
    f.broken = true;
    f.advice = travel_advice(g, plan, knots[i - 1].master, knots[i].master);
    report.findings.push_back(std::move(f));
  }
  sort(report);
  return report;
}

std::optional<double> master_period(const FollowPlan& plan) {
  if (!plan.periodic) return std::nullopt;
  return knots_of(plan).back().master;
}

}  // namespace jounce
