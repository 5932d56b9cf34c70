// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "jounce/cam/coupling/master_limits.hpp"
#include "jounce/gear/flying_shear.hpp"
#include "jounce/gear/rotary_knife.hpp"
#include "jounce/profiles/curve/jet.hpp"
#include "jounce/profiles/limits/limits.hpp"

namespace jounce {

/// A machine that cuts a moving web. A Cutter does not use its `cut_length`.
using CutMachine = std::variant<RotaryKnifeSpec, FlyingShear>;

/// The fastest line that a cutter must follow, and the limits of its slave.
struct CutLine {
  double speed = 0;        ///< m/s, > 0
  MasterRates rates = {};  ///< greatest acceleration and jerk of the line
  Limits slave = {};       ///< limits over time: u/s, u/s^2, u/s^3
};

/// The motion of a rotary knife or a flying shear between cuts at any positions of the web.
///
///     const Cutter knife(RotaryKnifeSpec{.diameter = 3, .sync_angle = 0.17, .dwell = true});
///     const Jet y = knife.link(4.71, 1.2);         // 1.2 in after a cut; the next cut is at 4.71
///
/// **Home** is the position in which the cutter waits at rest: for a shear, the position 0; for a
/// knife, halfway between two cuts. Three motions connect home and cuts:
///
/// - approach: from home to a cut,
/// - link: from a cut to the next cut, without a rest at home,
/// - retreat: from a cut to home.
///
/// If a piece is long enough for a retreat and an approach, the cutter waits at home in between. A
/// shear without `return_length` links pieces of any length: its return takes the rest of the
/// piece.
///
/// **Frame.** The cut is at u = 0 of the web; for a shear, this is the start of its sync zone. The
/// slave is at 0 at the cut of a knife. Each cut advances the slave by turn().
///
/// m is the unit of the web, u that of the slave. Derivatives are with respect to the web. The
/// motions do not allocate or throw; they may be called in a cyclic thread.
class Cutter {
 public:
  /// Throws InputError like rotary_knife() and flying_shear(), and for a shear whose sync depends
  /// on the cut length (neither sync_time nor sync_length is given).
  ///
  /// `line`: the line, if it changes its speed. The way home of a shear without `return_length` is
  /// then the shortest one with which the slave keeps its limits on this line, but not shorter than
  /// at a constant speed.
  explicit Cutter(const CutMachine& machine, const CutLine& line = {});
  ~Cutter();
  Cutter(Cutter&&) noexcept;
  Cutter& operator=(Cutter&&) noexcept;

  [[nodiscard]] double approach() const;  ///< m, length of web from leaving home to the cut
  [[nodiscard]] double retreat() const;   ///< m, length of web from a cut to the rest at home
  /// m, length of web from a cut to the beginning of the motion to the next cut. Until then, the
  /// next cut may still change.
  [[nodiscard]] double commit() const;
  [[nodiscard]] double sync_before() const;  ///< m, length of web in step before a cut
  [[nodiscard]] double sync_after() const;   ///< m, length of web in step after a cut
  [[nodiscard]] double turn() const;         ///< u, advance of the slave for each cut; shear: 0
  [[nodiscard]] double home() const;         ///< u, position at home after the cut at 0
  /// m: every piece is longer than this (knife), or at least as long (shear).
  [[nodiscard]] double shortest() const;
  /// m: the longest piece; infinite unless a knife must not stop.
  [[nodiscard]] double longest() const;
  /// True if a cutter moves from cut to cut without a rest at home, for a piece of this length (m).
  [[nodiscard]] bool links(double length) const;

  /// Position (u) and derivatives in the approach from home to a cut. `at`: position of the web
  /// relative to the cut, m; negative, because it is before the cut.
  [[nodiscard]] Jet approach(double at) const;
  /// Position and derivatives in the retreat from a cut to home. `at`: position of the web relative
  /// to the cut, m, > 0.
  [[nodiscard]] Jet retreat(double at) const;
  /// Position and derivatives in the link between two cuts. `at`: position of the web relative to
  /// the first cut, m; `length`: distance of the two cuts on the web, m.
  [[nodiscard]] Jet link(double length, double at) const;

  /// Segments with the names of the parts of the motion; the last value is exact.
  struct Parts {
    std::vector<Segment> segments = {};
    std::vector<std::string> names = {};
  };
  /// Appends a motion to `to`, with `offset` (u) added to its positions. A piece that does not link
  /// consists of a retreat, a rest and an approach.
  void add_approach(Parts& to, double offset) const;
  void add_retreat(Parts& to, double offset) const;
  void add_piece(Parts& to, double length, double offset) const;

 private:
  struct Shape;
  [[nodiscard]] Jet middle(double length, double at) const;
  void add_middle(Parts& to, double length, double from, double until, double offset,
                  const char* name) const;

  std::unique_ptr<const Shape> shape_;
};

/// A range of lengths, m.
struct CutRange {
  double from = 0;
  double to = std::numeric_limits<double>::infinity();
};

/// Returns the lengths of pieces that the cutter can make on this line within the limits of its
/// slave, in ascending ranges.
///
/// **Exactness.** Each bound is a root, to 1e-13 of its value, and the limits hold on the whole cam
/// (greatest_master_velocity()). For a shear, the bound is Cutter::shortest(). Below its
/// synchronous length, a knife has one bound, because a longer piece requires less speed and less
/// acceleration everywhere. Above this length, a grid of 64 lengths separates the bounds.
///
/// Throws InputError for the key "line_speed" if the motion from home to a cut, or back, exceeds a
/// limit. The rule of the error states the greatest possible line speed.
std::vector<CutRange> possible_lengths(const Cutter& cutter, const CutLine& line);

}  // namespace jounce
