// SPDX-License-Identifier: Apache-2.0
#include "path/src/timing/laws.hpp"

#include <algorithm>
#include <cmath>

#include "jounce/profiles/detail/large_pages.hpp"

#include "path/src/timing/command_boxes.hpp"
#include "path/src/timing/not_limited.hpp"
#include "path/src/timing/turn_chains.hpp"
#include "path/src/timing/window.hpp"

namespace jounce {

using profiles_detail::reserve_large;

LawStretches stretches_of(const Path& path, std::size_t first, std::size_t count,
                          std::span<const LawPhase> phases) {
  LawStretches law;
  double time = 0;
  std::size_t piece = first;
  const std::size_t last = first + count - 1;
  const double origin = path.pieces()[first].start;
  for (const LawPhase& p : phases) {
    LawInterval s;
    s.time = time;
    s.duration = p.duration;
    s.start = p.position;
    const double h = p.duration;
    s.length = h * (p.velocity + h * (p.acceleration / 2 + h * p.jerk / 6));
    s.v0 = p.velocity;
    s.v1 = s.peak = p.velocity + h * (p.acceleration + h * p.jerk / 2);
    s.acceleration = p.acceleration;
    s.jerk = p.jerk;
    const auto end_of_piece = [&](std::size_t k) {
      return path.pieces()[k].start + path.pieces()[k].length - origin;
    };
    while (piece < last && end_of_piece(piece) <= s.start) ++piece;
    s.piece = static_cast<std::uint32_t>(piece);
    std::size_t to = piece;
    while (to < last && end_of_piece(to) < s.start + s.length) ++to;
    s.pieces = static_cast<std::uint32_t>(to - piece + 1);
    time += h;
    if (&p == &phases.back()) s.v1 = 0;  // exactly, without rounding
    law.push_back(s);
  }
  return law;
}

namespace {

using path_detail::unlimited;
constexpr double reserve = 1 + 1e-9;  ///< for rounding of the times in an average

double end_time(const LawStretches& law) {
  return law.empty() ? unlimited : law.end_time();
}

/// The law of a window over the pieces of a run. Its accelerations and jerks are shares of the rest
/// of the limits on the straightest piece; the fastest of several shares is used. Empty if the axes
/// have no jerk limit.
class WindowLaw {
 public:
  WindowLaw(const Path& path, std::span<const Unit> units, const Rates& rates,
            const Program& program)
      : path_(path),
        rates_(reserved(rates)),
        settings_(program.settings()),
        limited_(limit_axes(program.settings())),
        first_(units.front().piece) {
    for (const Unit& unit : units)
      for (std::uint32_t k = 0; k < unit.pieces; ++k) {
        rates.require_wanted();
        const std::size_t piece = unit.piece + k;
        if (piece < first_ + bounds_.size()) continue;  // a part of an arc
        const PathSettings& settings = program.settings()[path.pieces()[piece].settings];
        length_ += path.pieces()[piece].length;
        bounds_.push_back(derivatives_of(path, piece, rates.path_axes));
        corners_.push_back(is_corner(path.pieces()[piece]));
        const Rates here = rates_of_piece(bounds_.size() - 1);
        double feed = std::min(settings.velocity, rates.path.velocity) / bounds_.back().speed;
        if (corners_.back()) feed = std::min(feed, unit.box.velocity);
        feeds_.push_back(feed);
        entries_.push_back(k == 0 ? unit.entry : unlimited);
        acceleration_ = std::min({acceleration_, settings.acceleration, settings.deceleration});
        jerk_ = std::min(jerk_, settings.jerk);
        for (std::size_t i = 0; i < rates.axes; ++i) {
          if (!(bounds_.back().first[i] > 0)) continue;
          acceleration_ = std::min(acceleration_, here.acceleration[i] / bounds_.back().first[i]);
          jerk_ = std::min(jerk_, here.jerk[i] / bounds_.back().first[i]);
        }
      }
    const PathLimits& p = rates.path;
    acceleration_ = std::min({acceleration_, p.acceleration, p.deceleration, p.total_acceleration});
    jerk_ = std::min(jerk_, p.jerk);
  }

  LawStretches run() {
    if (!(acceleration_ < unlimited) || !(jerk_ < unlimited)) return {};
    double best = unlimited;
    double best_a = 0;
    double best_j = 0;
    std::vector<RawPhase> phases;
    for (const double a : {0.9, 0.6, 0.35, 0.2})
      for (const double j : {0.9, 0.6, 0.35}) {
        rates_.require_wanted();
        std::vector<RawPhase> next = raw(a * acceleration_, j * jerk_);
        if (next.empty()) continue;
        double time = a * acceleration_ / (j * jerk_);
        for (const RawPhase& p : next) time += p.duration;
        if (time < best) {
          best = time;
          best_a = a * acceleration_;
          best_j = j * jerk_;
          phases = std::move(next);
        }
      }
    if (phases.empty()) return {};
    return stretches_of(path_, first_, bounds_.size(), averaged(phases, best_a / best_j, length_));
  }

 private:
  /// The limits on the k-th piece of the run.
  [[nodiscard]] Rates rates_of_piece(std::size_t k) const {
    return limited_ ? rates_on(rates_, path_.pieces()[first_ + k], settings_, corners_[k]) : rates_;
  }

  [[nodiscard]] double velocity_of_piece(std::size_t k, double acceleration, double jerk) const {
    return limited_ ? velocity_with(rates_of_piece(k), bounds_[k], acceleration, jerk)
                    : velocity_with(rates_, bounds_[k], acceleration, jerk);
  }

  [[nodiscard]] std::vector<RawPhase> raw(double acceleration, double jerk) const {
    std::vector<CappedLength> caps;
    caps.reserve(bounds_.size());
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const double v = std::min(
          {feeds_[k], entries_[k], velocity_of_piece(k, acceleration * reserve, jerk * reserve)});
      if (!(v > 0) || !(v < unlimited)) return {};
      caps.push_back({path_.pieces()[first_ + k].length, v});
    }
    return spread_law(caps, acceleration, acceleration / jerk);
  }

  const Path& path_;
  Rates rates_;
  std::span<const PathSettings> settings_;
  bool limited_;
  std::size_t first_;
  std::vector<Derivatives> bounds_;
  std::vector<bool> corners_;
  std::vector<double> feeds_, entries_;
  double acceleration_ = unlimited, jerk_ = unlimited;
  double length_ = 0;
};

/// The laws of the runs of a path.
class Runs {
 public:
  Runs(const Path& path, const Rates& rates, const Program& program)
      : path_(path),
        rates_(rates),
        program_(program),
        has_curves_(std::ranges::any_of(
            path.pieces(), [](const PathPiece& piece) { return piece.kind == PieceKind::curve; })) {
  }

  /// True if stretch_of() gives the law of the run.
  [[nodiscard]] bool is_one_stretch(std::span<const Unit> run) const {
    return run.size() == 1 && !is_curved(run);
  }

  /// The faster of both laws.
  [[nodiscard]] LawStretches fastest(std::vector<Unit> run) const {
    run.front().entry = unlimited;
    if (!is_curved(run)) return stations(std::move(run));
    LawStretches law = stations(run);
    LawStretches window = WindowLaw(path_, run, rates_, program_).run();
    return end_time(window) < end_time(law) ? window : law;
  }

 private:
  /// True if a window may be faster: on curves, where ramps extend over many pieces with different
  /// boxes.
  [[nodiscard]] bool is_curved(std::span<const Unit> units) const {
    return has_curves_ && std::ranges::any_of(units, [&](const Unit& unit) {
             return path_.pieces()[unit.piece].kind == PieceKind::curve;
           });
  }

  const Path& path_;
  const Rates& rates_;
  const Program& program_;
  bool has_curves_;
};

/// Sums the durations of the runs of a motion that rests at each corner.
class StopTimes final : public UnitSink {
 public:
  StopTimes(const Route& route, const Program& program, const Rates& rates,
            std::span<const Rest> at)
      : route_(route),
        runs_(route.path, rates, program),
        commands_(route.path, rates, program),
        at_(at) {
    times_.reserve(at.size() + 1);
  }

  void add(const Unit& unit) override {
    if (!(unit.entry > 0)) {
      finish_run();
      rest(unit.joint, unit.dwell);
    }
    run_.push_back(unit);
  }

  std::vector<double> times() {
    finish_run();
    time_ += route_.joints.back().dwell;
    times_.resize(at_.size() + 1, time_);
    return std::move(times_);
  }

 private:
  void rest(std::uint32_t joint, double dwell) {
    if (times_.size() < at_.size() && at_[times_.size()].joint == joint) times_.push_back(time_);
    time_ += dwell;
  }

  void finish_run() {
    if (run_.empty()) return;
    if (commands_.limited()) run_ = commands_.lowered(std::move(run_));
    time_ += runs_.is_one_stretch(run_) ? stretch_of(run_.front(), 0, 0).duration
                                        : end_time(runs_.fastest(run_));
    run_.clear();
  }

  const Route& route_;
  const Runs runs_;
  const CommandBoxes commands_;
  std::span<const Rest> at_;
  std::vector<Unit> run_;
  std::vector<double> times_;
  double time_ = 0;
};

/// Collects the laws of the runs, and the rests between them.
struct Collected {
  Laws laws;
  double time = 0;
  double start = 0;  ///< q
  bool times_only = false;

  void add(LawInterval s) {
    s.time += time;
    s.start += start;
    if (!times_only) laws.stretches.push_back(s);
  }

  void rest(std::uint32_t joint, double dwell, std::uint32_t piece) {
    laws.rests.push_back({joint, time});
    if (!(dwell > 0)) return;
    LawInterval s;
    s.duration = dwell;
    s.piece = piece;
    add(s);
    time += dwell;
  }

  void run(LawStretches law, const PathPiece& last) {
    const double duration = end_time(law);
    if (laws.stretches.empty() && time == 0 && !times_only)
      laws.stretches = std::move(law);
    else
      for (const LawInterval& s : law) add(s);
    moved(duration, last);
  }

  /// Moves the end: q is that of the path, and the time is the sum of the durations.
  void moved(double duration, const PathPiece& last) {
    time += duration;
    start = last.start + last.length;
  }
};

}  // namespace

Laws fastest_law(Rounded& rounded, const Rates& rates, const Program& program, const Route& route,
                 bool times_only) {
  std::vector<Unit> units = std::move(rounded.units);
  const Path& path = rounded.path ? *rounded.path : route.path;
  const CommandBoxes commands(path, rates, program);
  if (commands.limited()) units = commands.lowered(std::move(units));
  if (rounded.path) open_chains(units, path, rates, program.settings());
  Collected made;
  made.times_only = times_only;
  const Runs runs(path, rates, program);
  const auto rests = static_cast<std::size_t>(
      std::ranges::count_if(units, [](const Unit& unit) { return !(unit.entry > 0); }));
  reserve_large(made.laws.rests, rests + 1);
  if (rests > 1 && !times_only)
    made.laws.stretches.reserve(units.size(), LawStretches::numbers_of_ramps * units.size());
  for (std::size_t i = 0; i < units.size();) {
    rates.require_wanted();
    std::size_t last = i + 1;
    while (last < units.size() && units[last].entry > 0) ++last;
    const std::span<const Unit> run(units.data() + i, last - i);
    made.rest(run.front().joint, run.front().dwell, run.front().piece);
    const PathPiece& end = path.pieces()[run.back().piece + run.back().pieces - 1];
    if (runs.is_one_stretch(run)) {
      const LawInterval s = stretch_of(run.front(), 0, 0);
      made.add(s);
      made.moved(s.duration, end);
    } else if (run.size() == units.size()) {
      made.run(runs.fastest(std::move(units)), end);
      break;
    } else {
      made.run(runs.fastest({run.begin(), run.end()}), end);
    }
    i = last;
  }
  made.rest(static_cast<std::uint32_t>(route.joints.size() - 1), route.joints.back().dwell,
            static_cast<std::uint32_t>(path.pieces().size() - 1));
  made.laws.rests.back().time = made.time;
  return std::move(made.laws);
}

std::vector<double> stop_times(const Route& route, const Lines& lines, const Program& program,
                               const Rates& rates, std::span<const CornerShape> shapes,
                               std::span<const Rest> at) {
  StopTimes sum(route, program, rates, at);
  send_stopping_units(route, lines, program, rates, shapes, sum);
  return sum.times();
}

}  // namespace jounce
