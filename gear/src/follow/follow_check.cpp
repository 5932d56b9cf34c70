// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "jounce/gear/follow.hpp"
#include "jounce/profiles/detail/numeric.hpp"
#include "jounce/profiles/detail/six_digits.hpp"

#include "gear/src/follow/follow_passes.hpp"

namespace jounce {
namespace {

using gear_detail::FollowPass;

using profiles_detail::rounded_input;

/// The increments of a segment.
struct Travel {
  double master = 0;
  double slave = 0;
};

Travel travel_of(const FollowTable& table, std::size_t i) {
  const PtPoint before = i > 0 ? table.segments[i - 1] : PtPoint{};
  return {table.segments[i].x - before.x, table.segments[i].position - before.position};
}

/// The median travel of all segments except the given one: the usual travel in these tables.
/// nullopt for fewer than three segments.
std::optional<double> usual(const FollowSpec& spec, std::size_t table, std::size_t segment,
                            double Travel::*part) {
  std::vector<double> all;
  for (std::size_t t = 0; t < spec.tables.size(); ++t)
    for (std::size_t i = 0; i < spec.tables[t].segments.size(); ++i)
      if (t != table || i != segment) all.push_back(std::abs(travel_of(spec.tables[t], i).*part));
  if (all.size() < 3) return std::nullopt;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

bool is_odd(double travel, std::optional<double> usual) {
  constexpr double often = 3;
  if (!usual || *usual == 0 || travel == 0) return false;
  const double share = std::abs(travel) / *usual;
  return share >= often || share <= 1 / often;
}

/// Possible cause for a segment in which the slave moves backwards.
std::string advice(const FollowSpec& spec, std::size_t table, std::size_t i, double start) {
  const auto [master, slave] = travel_of(spec.tables[table], i);
  const auto misprint = [&](const char* whose, double is, double would_be, double end) {
    return std::string("in this segment, the ") + whose + " travels " + six_digits(is) + ", " +
           six_digits(std::abs(is) / would_be) +
           " times as far as in the other segments, where the " + whose + " travels " +
           six_digits(would_be) +
           ": check this number. With the travel of the others, the segment would end at the "
           "ratio " +
           six_digits(end);
  };
  const auto m = usual(spec, table, i, &Travel::master);
  if (is_odd(master, m)) return misprint("master", master, *m, 2 * slave / *m - start);
  const auto s = usual(spec, table, i, &Travel::slave);
  if (is_odd(slave, s))
    return misprint("slave", slave, *s, std::copysign(2 * *s, slave) / master - start);
  return "before it reverses, the slave travels " + six_digits(start * master / 2) +
         ", and after that, the slave travels " + six_digits(slave - start * master / 2) +
         ": move the point, or add a point where the slave reverses";
}

class Inspection {
 public:
  explicit Inspection(const FollowSpec& spec)
      : spec_(spec), passes_(gear_detail::follow_passes(spec)) {
    for (const FollowPass& pass : passes_)
      for (const PtRate& r : pass.ratios)
        peak_ = std::max({peak_, std::abs(r.start), std::abs(r.end)});
    double before = spec_.start_ratio;
    for (const FollowPass& pass : passes_) {
      inspect(pass, before);
      before = pass.ratios.back().end;
      first_ += pass.ratios.size();
    }
    after_the_last(before);
    ends();
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (places_[i] > 1)
        report_.findings[i].advice += " (" + std::to_string(places_[i]) + " such places)";
    sort(report_);
  }

  [[nodiscard]] Report report() && { return std::move(report_); }

 private:
  [[nodiscard]] bool counts(double ratio) const { return std::abs(ratio) > rounded_input * peak_; }

  void inspect(const FollowPass& pass, double before) {
    const auto& segments = spec_.tables[pass.table].segments;
    if (segments.front().type != PtType::continued) chained_ = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const PtRate& ratio = pass.ratios[i];
      const double master = i > 0 ? segments[i - 1].x : 0;
      step(pass, i, pass.master + master, before, ratio.start);
      const bool anew = segments[i].type == PtType::even || segments[i].type == PtType::stop;
      if (anew) chained_ = false;
      reversal(pass, i);
      before = ratio.end;
    }
  }

  void step(const FollowPass& pass, std::size_t i, double where, double from, double to) {
    if (!counts(to - from)) return;
    const bool start = first_ == 0 && i == 0;
    const std::string ratios = "from " + six_digits(from) + " to " + six_digits(to);
    Finding f = finding("follow/ratio_step", first_ + i, where, std::abs(to - from));
    f.quantity = "step of geo_velocity";
    f.advice = "the ratio steps " + ratios +
               ": change the end of this segment, or give it type = \"normal\"";
    if (start) {
      f.severity = Severity::warning;
      f.broken = !gear_detail::repeats(spec_, passes_);
      f.advice = "the ratio steps " + ratios +
                 " at the start: give start_ratio if the slave already moves";
    } else if (i == 0 && pass.again) {
      f.rule = "follow/wrap_step";
      f.advice = wrap_advice(ratios);
    } else if (i == 0) {
      f.rule = "follow/switch_step";
      f.advice = "the ratio steps " + ratios + ": let table " + std::to_string(pass.table + 1) +
                 " begin with a continue segment";
    }
    add(std::move(f));
  }

  static std::string wrap_advice(const std::string& ratios) {
    return "the ratio steps " + ratios +
           " from pass to pass: let the table begin with a continue segment, or end where it "
           "begins";
  }

  void reversal(const FollowPass& pass, std::size_t i) {
    const auto [start, end] = pass.ratios[i];
    const double slave = travel_of(spec_.tables[pass.table], i).slave;
    const bool against = counts(end) && (slave == 0 || std::signbit(end) != std::signbit(slave));
    if (chained_ || !against) return;
    const double where = pass.master + spec_.tables[pass.table].segments[i].x;
    Finding f = finding("follow/reversal", first_ + i, where, end);
    f.quantity = "geo_velocity";
    f.advice = advice(spec_, pass.table, i, start);
    add(std::move(f));
    chained_ = true;
  }

  /// Checks the end of the last pass, which ends at `ratio`.
  void after_the_last(double ratio) {
    const FollowPass& last = passes_.back();
    const FollowTable& table = spec_.tables[last.table];
    const double where = last.master + table.segments.back().x;
    if (table.loops >= 1) {
      if (!counts(ratio)) return;
      Finding f = finding("follow/open_end", first_ - 1, where, ratio);
      f.quantity = "geo_velocity";
      f.advice =
          "the controller stops the slave abruptly there, and an axis of Jounce brakes within its "
          "limits: end with a stop segment, repeat the table, or add another table";
      return add(std::move(f));
    }
    const auto again = pt_rates<OverMaster>(table.segments, ratio);
    if (!counts(again.back().end - ratio)) return wrap(where, ratio, again.front().start);
    const double later = pt_rates<OverMaster>(table.segments, again.back().end).back().end;
    Finding f = finding("follow/wrap_ratio", first_ - 1, where, again.back().end);
    f.quantity = "geo_velocity";
    const bool alternates = !counts(later - ratio);
    f.broken = !alternates;
    if (alternates) f.severity = Severity::warning;
    f.advice = "the first pass ends at the ratio " + six_digits(ratio) +
               ", the second pass at the ratio " + six_digits(again.back().end) +
               ", the third pass at the ratio " + six_digits(later) +
               ": end the table with the ratio with which it begins";
    add(std::move(f));
  }

  /// Checks the joint from the end of the last pass in the cam to the start of the next pass, which
  /// the cam does not contain.
  void wrap(double where, double from, double to) {
    if (!counts(to - from)) return;
    Finding f = finding("follow/wrap_step", first_ - 1, where, std::abs(to - from));
    f.quantity = "step of geo_velocity";
    f.advice = wrap_advice("from " + six_digits(from) + " to " + six_digits(to));
    add(std::move(f));
  }

  /// Checks the nominal ends (check sums) of the tables.
  void ends() {
    for (std::size_t i = 0; i < spec_.tables.size(); ++i) {
      const FollowTable& table = spec_.tables[i];
      if (!table.end) continue;
      const PtPoint& last = table.segments.back();
      const auto differ = [](double a, double b) {
        return std::abs(a - b) > rounded_input * std::max(std::abs(a), std::abs(b));
      };
      if (!differ(last.x, table.end->master) && !differ(last.position, table.end->slave)) continue;
      add(end_finding(i, {table.end->master - last.x, table.end->slave - last.position}));
    }
  }

  [[nodiscard]] Finding end_finding(std::size_t i, const Travel& missing) const {
    const FollowTable& table = spec_.tables[i];
    const PtPoint& last = table.segments.back();
    std::size_t segment = 0;
    for (const FollowPass& pass : passes_) {
      segment += pass.ratios.size();
      if (pass.table == i) break;
    }
    const bool of_master = missing.master != 0;
    const bool too_far = missing.master < 0 || missing.slave < 0;
    Finding f = finding("follow/end", segment - 1, last.x, of_master ? last.x : last.position);
    f.quantity = of_master ? "the master's travel" : "the slave's travel";
    f.limit = of_master ? table.end->master : table.end->slave;
    f.has_limit = true;
    f.margin = -std::abs((f.value - f.limit) / f.value);
    f.advice = "the segments end at master " + six_digits(table.segments.back().x) + ", slave " +
               six_digits(table.segments.back().position) +
               ", but the spec gives the end as master " + six_digits(table.end->master) +
               ", slave " + six_digits(table.end->slave) + ": " +
               (too_far ? "the difference is master " : "master ") + six_digits(missing.master) +
               (too_far ? ", slave " : " and slave ") + six_digits(missing.slave) +
               (too_far ? "" : " are missing" + as_segment(table, missing));
    return f;
  }

  /// Advice that names the segment with exactly this travel.
  static std::string as_segment(const FollowTable& table, const Travel& missing) {
    for (std::size_t i = 0; i < table.segments.size(); ++i) {
      const Travel t = travel_of(table, i);
      const double scale = rounded_input * table.segments.back().x;
      if (std::abs(t.master - missing.master) <= scale &&
          std::abs(t.slave - missing.slave) <=
              rounded_input * std::abs(table.segments.back().position))
        return ", which equals segment " + std::to_string(i + 1) +
               ": check whether a segment is missing";
    }
    return "";
  }

  [[nodiscard]] Finding finding(const char* rule, std::size_t segment, double where,
                                double value) const {
    Finding f;
    f.rule = rule;
    f.where = where;
    f.value = value;
    f.margin = -std::abs(value) / peak_;
    f.broken = true;
    f.segment = segment;
    f.has_limit = false;
    return f;
  }

  /// Keeps the worst finding of each rule; for reversals the first one, because later ones may
  /// follow from it.
  void add(Finding f) {
    std::size_t i = 0;
    while (i < places_.size() && report_.findings[i].rule != f.rule) ++i;
    if (i == places_.size()) {
      report_.findings.push_back(std::move(f));
      places_.push_back(1);
      return;
    }
    ++places_[i];
    if (f.margin < report_.findings[i].margin && f.rule != "follow/reversal")
      report_.findings[i] = std::move(f);
  }

  const FollowSpec& spec_;
  std::vector<FollowPass> passes_;
  double peak_ = 0;
  bool chained_ = false;  ///< true: a reversal is already reported, and further ones follow from it
  std::size_t first_ = 0;  ///< index of the cam's segment with which the pass begins
  Report report_;
  std::vector<std::size_t> places_;  ///< index of the place of each finding
};

}  // namespace

Report check(const FollowSpec& spec) {
  return Inspection(spec).report();
}

}  // namespace jounce
