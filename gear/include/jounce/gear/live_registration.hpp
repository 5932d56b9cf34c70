// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "jounce/gear/registration.hpp"
#include "jounce/profiles/curve/curve.hpp"

namespace jounce {

/// Reaction to too many missing marks in succession.
enum class MarkLoss : std::uint8_t {
  fault,  ///< the axis stops
  hold,   ///< the correction stays; the search for marks continues
};

/// Motion to which a correction is added.
enum class CorrectionOf : std::uint8_t {
  master,  ///< the position of the master (a phase): for slaves that return to a home position
  slave,   ///< the position of the slave: for slaves that rotate
};

/// A registration that runs while a slave follows its master. m is the unit of the master, c the
/// unit of the correction: m for CorrectionOf::master, the unit of the slave otherwise.
struct LiveRegistrationSpec {
  int input = 1;       ///< trigger input of the mark sensor
  bool rising = true;  ///< edge of a mark: true: the input goes on
  double period = 0;   ///< m, > 0: nominal distance of two marks, the length of a product
  /// m: position of the master at the edge of a mark that is in register, modulo `period`.
  double mark = 0;
  /// m, > 0, at most period / 2: greatest distance of a mark from the place at which it is
  /// expected.
  double window = 0;
  /// m, at least `window`, at most period / 2: the greatest distance until the first mark, and
  /// after a loss.
  double search = 0;
  /// The window of the correction, its law, and its greatest step in one product (c). The window
  /// consists of positions of the master (or of its phase) modulo `period`, and may extend beyond
  /// the end of the period.
  Registration correction = {};
  CorrectionOf add_to = CorrectionOf::master;  ///< see CorrectionOf
  double ratio =
      1;  ///< c per m, != 0: travel of the slave in its sync zone, for CorrectionOf::slave
  double gain = 1;  ///< > 0, <= 1: share of the error that one product corrects
  int misses = 3;   ///< >= 1: number of missing marks in succession that counts as a loss
  MarkLoss on_loss = MarkLoss::fault;  ///< reaction to a loss
};

/// State of a registration.
struct RegistrationReading {
  double deviation = 0;     ///< m: position of the last mark, minus its place in register
  double correction = 0;    ///< c: present correction
  std::int64_t marks = 0;   ///< number of accepted marks
  std::int64_t missed = 0;  ///< number of products without a mark
  std::int64_t strays = 0;  ///< number of marks outside the window
  bool lost = false;        ///< true from a loss to the next accepted mark
};

/// Registration, cycle by cycle: from the positions of marks to the correction of a slave.
///
///     LiveRegistration marks(spec);
///     marks.begin(master[0]);                          // the slave engages
///     marks.step(master, reported, found);             // once a cycle
///     slave_follows(master[0] + marks.correction()[0]);  // CorrectionOf::master
///
/// Let M be the position of mark k, L the period, p its place in register, a the applied
/// correction.
///
///     (1)  d = M - (k L + p)                    deviation
///     (2)  s = clamp(gain (-r d - a), -most, most),  r = 1 (master) or `ratio` (slave)
///     (3)  c = a + s f((x - x0) / b)            correction at the master's position x
///
/// f is the law, x0 the start of the window of the correction, b its length (b - s for
/// CorrectionOf::master, so the window ends at the same place of the phase). After the window, a
/// grows by s. Each mark has one correction, in the next window: without a new mark, c stays. A
/// mark is expected at k L + p + d, with the deviation d of the previous mark. A mark further away
/// than `window` is a stray, and so is a second mark of a product: both have no effect.
///
/// The master may stand or reverse: inside a window, c depends only on x. A correction whose window
/// has ended is not taken back.
///
/// step() does not allocate, lock or throw.
class LiveRegistration {
 public:
  /// Throws InputError with the key of the field for an invalid value.
  explicit LiveRegistration(const LiveRegistrationSpec& spec);

  /// Begins without a correction, with the master at this position, m.
  void begin(double master) noexcept;
  /// Adds `by` (m) to the coordinate of the master: all later positions are greater by this
  /// distance. The places of the products on the material do not change.
  void shift(double by) noexcept { shift_ += by; }
  /// Computes one cycle. `master`: position, m, and its derivatives. `reported`: position of the
  /// master up to which the sensor has reported its marks, m; NaN: unknown. `marks`: positions of
  /// the master at the marks that were reported since the previous cycle, m, ascending.
  void step(const Jet& master, double reported, std::span<const double> marks) noexcept;

  /// The correction in this cycle and its derivatives with respect to time: c, c/s, c/s^2, c/s^3.
  [[nodiscard]] const Jet& correction() const noexcept { return correction_; }
  /// State after this cycle.
  [[nodiscard]] const RegistrationReading& reading() const noexcept { return now_; }
  /// The spec.
  [[nodiscard]] const LiveRegistrationSpec& spec() const noexcept { return spec_; }

 private:
  void take(double mark) noexcept;
  void miss(double reported) noexcept;
  void plan(double x) noexcept;
  [[nodiscard]] Jet at(double x) const noexcept;
  [[nodiscard]] double reach() const noexcept { return found_ ? spec_.window : spec_.search; }

  LiveRegistrationSpec spec_;
  Cam law_;  // from 0 to 1 over a length of 1
  bool of_master_;

  double shift_ = 0;              // change of the master's coordinate since begin(), m
  double product_ = 0;            // number of the last product whose mark was found or missed
  double first_ = 0;              // number of the first product whose whole window is seen
  bool found_ = false;            // true if the place of the next mark is known
  int misses_ = 0;                // in succession
  double needed_ = 0;             // whole correction that the last mark requires, c
  bool fresh_ = false;            // true if no window of the correction has used needed_
  double applied_ = 0;            // c
  double last_ = 0;               // position of the master in the previous cycle, m
  bool moving_ = false;           // true inside a window with a correction step
  double from_ = 0, length_ = 1;  // that window, m
  double step_ = 0;               // its step, c
  Jet correction_{};
  RegistrationReading now_;
};

}  // namespace jounce
