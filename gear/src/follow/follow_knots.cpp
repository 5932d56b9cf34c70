// SPDX-License-Identifier: Apache-2.0
#include "gear/src/follow/follow_knots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jounce/profiles/detail/entry_key.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/detail/local_velocities.hpp"

namespace jounce::gear_detail {
namespace {

using profiles_detail::entry_key;
using profiles_detail::rounded_input;

bool near(double a, double b) {
  return std::abs(a - b) <= rounded_input * std::max(std::abs(a), std::abs(b));
}

/// A sync point or a zone, for sorting by master position.
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
      throw InputError("point", "", "is missing: add a [[point]] or a [[zone]] after the start");
    close();
    fill();
  }

  [[nodiscard]] std::vector<FollowKnot> all() && { return std::move(all_); }

 private:
  void require_numbers() const {
    if (plan_.start_ratio) require_finite("start_ratio", *plan_.start_ratio);
    for (std::size_t i = 0; i < plan_.points.size(); ++i) {
      const FollowPoint& p = plan_.points[i];
      require_finite(entry_key("point", i, "master").c_str(), p.master);
      require_finite(entry_key("point", i, "slave").c_str(), p.slave);
      require_finite(entry_key("point", i, "ratio").c_str(), p.ratio.value_or(0));
      if (i > 0 && !(p.master > plan_.points[i - 1].master))
        throw InputError(
            entry_key("point", i, "master"), p.master,
            "must be greater than " + number(plan_.points[i - 1].master) + ", the previous point");
    }
    for (std::size_t i = 0; i < plan_.zones.size(); ++i) {
      const FollowZone& z = plan_.zones[i];
      require_finite(entry_key("zone", i, "from").c_str(), z.from);
      require_finite(entry_key("zone", i, "to").c_str(), z.to);
      require_finite(entry_key("zone", i, "ratio").c_str(), z.ratio);
      require_finite(entry_key("zone", i, "slave").c_str(), z.slave.value_or(0));
      if (!(z.to > z.from))
        throw InputError(entry_key("zone", i, "to"), z.to,
                         "must be greater than from = " + number(z.from));
      if (i > 0 && !(z.from >= plan_.zones[i - 1].to))
        throw InputError(
            entry_key("zone", i, "from"), z.from,
            "must be at least " + number(plan_.zones[i - 1].to) + ", the end of the previous zone");
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
      throw InputError(entry_key("point", i, "master"), p.master,
                       "must be greater than " + number(all_.back().master) +
                           ", the place of the start, of a point or of a zone");
    all_.push_back({p.master, p.slave, p.ratio, {}});
  }

  void add_zone(std::size_t i) {
    const FollowZone& z = plan_.zones[i];
    FollowKnot& before = all_.back();
    if (z.from < before.master)
      throw InputError(
          entry_key("zone", i, "from"), z.from,
          "must be at least " + number(before.master) + ", the end of the previous zone or point");
    const double slave = begin_of(i);
    if (z.from == before.master) {
      join(i, before, slave);
    } else {
      all_.push_back({z.from, slave, z.ratio, {}});
    }
    all_.push_back({z.to, slave + z.ratio * (z.to - z.from), z.ratio, i});
  }

  /// Joins a zone to the knot at which it begins: the start of the plan, or the end of another
  /// zone.
  void join(std::size_t i, FollowKnot& before, double slave) const {
    const double ratio = plan_.zones[i].ratio;
    if (!near(slave, before.slave))
      throw InputError(entry_key("zone", i, "slave"), slave,
                       "must be " + six_digits(before.slave) +
                           ", the position that the slave has there: leave slave out, or change "
                           "the previous point or zone");
    if (before.ratio && !near(*before.ratio, ratio))
      throw InputError(
          entry_key("zone", i, "ratio"), ratio,
          "must be " + six_digits(*before.ratio) +
              ", the ratio that the slave has there: let it reach the new ratio before this zone");
    before.ratio = ratio;
  }

  /// Position of the slave at the beginning of the zone.
  [[nodiscard]] double begin_of(std::size_t i) const {
    const FollowZone& z = plan_.zones[i];
    std::optional<double> slave = z.slave;
    for (std::size_t k = 0; k < plan_.points.size(); ++k) {
      const FollowPoint& p = plan_.points[k];
      if (p.master < z.from || p.master > z.to) continue;
      const double expected = p.slave - z.ratio * (p.master - z.from);
      const double scale = std::abs(p.slave) + std::abs(z.ratio * z.to);
      if (slave && std::abs(*slave - expected) > rounded_input * scale)
        throw InputError(entry_key("point", k, "slave"), p.slave,
                         "must be " + six_digits(*slave + z.ratio * (p.master - z.from)) +
                             ", the position of the slave in zone " + std::to_string(i + 1) +
                             " at master = " + number(p.master) + " (" +
                             entry_key("zone", i, "from") + " = " + number(z.from) + ", " +
                             entry_key("zone", i, "to") + " = " + number(z.to) +
                             "): correct the master, or leave the point out");
      if (!slave) slave = expected;
    }
    if (slave) return *slave;
    const FollowKnot& before = all_.back();
    if (!before.ratio && all_.size() > 1)
      throw InputError(entry_key("zone", i, "slave"), "",
                       "is missing: give it, a sync point within the zone, or a ratio to the point "
                       "before");
    return before.slave + (before.ratio.value_or(z.ratio) + z.ratio) / 2 * (z.from - before.master);
  }

  /// Completes the ratios at the ends of the plan.
  void close() {
    FollowKnot& first = all_.front();
    FollowKnot& last = all_.back();
    if (!plan_.periodic) {
      if (!last.ratio) last.ratio = 0;
      return;
    }
    // If no ratio is given at the start, it is the ratio at the end.
    if (!plan_.start_ratio && !begins_in_step() && last.ratio) first.ratio = last.ratio;
    if (!last.ratio) last.ratio = first.ratio;
    if (!near(*first.ratio, *last.ratio))
      throw InputError("periodic", "true",
                       "needs the same ratio at start and end: at the start, ratio = " +
                           six_digits(*first.ratio) +
                           "; at the end, ratio = " + six_digits(*last.ratio));
  }

  /// Computes the omitted ratios. They are between the mean ratios before and after, so nothing
  /// overshoots.
  void fill() {
    for (std::size_t i = 1; i + 1 < all_.size(); ++i) {
      if (all_[i].ratio) continue;
      const double h0 = all_[i].master - all_[i - 1].master;
      const double h1 = all_[i + 1].master - all_[i].master;
      all_[i].ratio = pvt_detail::between_chords(h0, (all_[i].slave - all_[i - 1].slave) / h0, h1,
                                                 (all_[i + 1].slave - all_[i].slave) / h1);
    }
  }

  const FollowPlan& plan_;
  std::vector<FollowKnot> all_;
};

}  // namespace

std::vector<FollowKnot> follow_knots(const FollowPlan& plan) {
  return Knots(plan).all();
}

}  // namespace jounce::gear_detail
