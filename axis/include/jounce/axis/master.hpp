// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "jounce/axis/ring.hpp"
#include "jounce/axis/tracker.hpp"
#include "jounce/pvt/table.hpp"

namespace jounce {

/// A measured position of a master, with the time of the measurement by the sender's clock. m is
/// the unit of the master.
struct MasterSample {
  std::int64_t stamp_ns = 0;  ///< time of the measurement by the clock of the sender, ns
  /// Number of the sender's clock. A new number means another clock, or a restarted one.
  std::int32_t clock = 0;
  double received = 0;  ///< time of arrival, s, by the clock of Master::at()
  double position = 0;  ///< position, m
  bool valid = true;    ///< false if the sender reports that its position is invalid
};

/// Difference between the measured motion of a master and its output.
struct MasterLag {
  double distance = 0;  ///< measured position minus position of the output, m
  double velocity = 0;  ///< measured velocity, m/s; not limited, unlike the velocity of the output
};

/// A position that axes follow. (A master may also be the setpoint of another axis; the machine in
/// machine.hpp passes such a setpoint to the follower without this class.)
///
///     ExternalMaster line({.velocity = 3, .acceleration = 20});    // m/s, m/s^2
///     line.receive({.stamp_ns = stamp, .received = now, .position = 1.25});  // communication thread
///     const Jet x = line.at(tick * period);                                // in each cycle
///     if (std::isnan(x[0])) ...                                            // none, or lost
class Master {
 public:
  Master() = default;
  virtual ~Master() = default;
  Master(const Master&) = delete;
  Master& operator=(const Master&) = delete;

  /// Returns the position and its derivatives at `time`: m, m/s, m/s^2, m/s^3. The position is NaN
  /// if the master is lost. Call once in each cycle, with ascending times (s). Does not allocate,
  /// wait or throw.
  virtual Jet at(double time) noexcept = 0;
  /// Returns the age of the measurement, s. NaN: no measurement yet. 0: the position is computed.
  [[nodiscard]] virtual double age(double /*time*/) const noexcept { return 0; }
  /// Returns the lag of the last at(). A computed position has none.
  [[nodiscard]] virtual MasterLag lag() const noexcept { return {}; }
  /// The samples that the last at() used for the first time. With them, all results can be computed
  /// again: another object of the same class that receives the same samples before the same calls
  /// of at() returns exactly the same results.
  [[nodiscard]] virtual std::span<const MasterSample> taken() const noexcept { return {}; }
};

/// The value of a master in one cycle.
struct MasterReading {
  std::int64_t tick = -1;  ///< number of the cycle; -1: none
  /// Result of Master::at().
  Jet at = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};
  /// Result of Master::age(), s.
  double age = std::numeric_limits<double>::quiet_NaN();
  MasterLag lag = {};  ///< result of Master::lag()

  /// True if the position is NaN.
  [[nodiscard]] bool lost() const { return std::isnan(at[0]); }
};

/// A virtual master: a table over time that begins at the time `start`, s. Before `start`, the
/// master stands at the first point. After the end of the table, it stands at the last point or
/// repeats, depending on the policy of the table.
class TableMaster final : public Master {
 public:
  /// Throws InputError with the key "axis" for a table that is not over time, and with the key
  /// "start" if `start` is not finite.
  explicit TableMaster(std::shared_ptr<const Table> table, double start = 0);
  Jet at(double time) noexcept override;

 private:
  std::shared_ptr<const Table> table_;
  double start_;
};

/// An encoder that is read in the cyclic thread. A filter removes noise and quantization
/// (tracker.hpp).
class EncoderMaster final : public Master {
 public:
  /// Each at() calls `position`, which returns the position of the encoder, m (NaN: no reading).
  /// `position` must not allocate, wait or throw. If it is omitted, call read() in each cycle. The
  /// master is lost after TrackerSpec::longest_age without a reading.
  explicit EncoderMaster(const TrackerSpec& spec, std::function<double()> position = {})
      : position_(std::move(position)), tracked_(spec) {}
  /// Sets the reading of this cycle. Call before at(). `time` is in s, `position` in m (NaN: no
  /// reading).
  void read(double time, double position) noexcept;
  Jet at(double time) noexcept override;
  [[nodiscard]] double age(double time) const noexcept override { return time - tracked_.seen(); }
  [[nodiscard]] MasterLag lag() const noexcept override {
    return {tracked_.lag(), tracked_.estimate().v};
  }
  /// The reading that the last at() used, if any: its position and, in `received`, its time, s.
  [[nodiscard]] std::span<const MasterSample> taken() const noexcept override {
    return {&taken_, was_read_ ? 1U : 0U};
  }
  /// Options of the filter.
  [[nodiscard]] const TrackerSpec& spec() const { return tracked_.spec(); }

 private:
  std::function<double()> position_;
  Tracked tracked_;
  MasterSample reading_, taken_;
  bool read_ = false;      // true if read() was called since the last at()
  bool was_read_ = false;  // true if read() was called before the last at()
};

/// Estimate of the offset between the sender's clock and the local one, without a round trip. For
/// each sample, received - stamp is the offset plus the transit time of the sample. Jitter can only
/// increase the transit time, so the minimum over recent samples is the offset plus the least
/// delay:
///
///     (1)  offset = least of received - stamp over the last window/2 to window
///
/// The estimate uses the minimum of each half of the window. The estimate moves towards the smaller
/// minimum, by at most `slew`, so that the master does not jump. At the first sample, and when the
/// error exceeds `step`, the estimate is set at once; such an error means that a clock was set.
///
/// The least delay cannot be measured from the samples. If it is known from another source, set
/// TrackerSpec::latency.
struct ClockOffset {
  /// Window of the minimum, s: long enough to contain a fast sample, short against the drift of
  /// quartz clocks.
  double window = 10;
  /// Greatest rate of change of the estimate, s/s; quartz clocks drift by less than 1e-4.
  double slew = 1e-3;
  double step = 0.25;     ///< error beyond which the estimate is set at once, s
  double offset = 0;      ///< the estimate: received - (stamp - base), s
  std::int64_t base = 0;  ///< the first stamp, ns; other stamps are relative to it
  bool known = false;     ///< true after the first sample

  /// Adds a sample and returns its time by the local clock, s. Sets `same` to false if the sample
  /// restarted the estimate.
  double local(const MasterSample& sample, bool& same) noexcept;

  std::int32_t clock = 0;  ///< clock of the last sample (MasterSample::clock)
  /// Least offset of the previous and the present half of the window, s.
  double least_before = 0, least_now = 0;
  double half_since = 0, last = 0;  ///< begin of the present half, and time of the last sample, s
};

/// An external master that sends samples over a bus. Samples may be late, lost or duplicated, and
/// their delay may vary. The position is extrapolated within the limits of the master. The master
/// is lost after TrackerSpec::longest_age without a sample.
class ExternalMaster final : public Master {
 public:
  explicit ExternalMaster(const TrackerSpec& spec) : tracked_(spec) {}
  /// Adds a sample; called by the communication thread. If at() has not yet taken the last 64
  /// samples, drops the sample and returns false.
  bool receive(const MasterSample& sample) noexcept { return samples_.push(sample); }
  /// Called by the cyclic thread.
  Jet at(double time) noexcept override;
  [[nodiscard]] double age(double time) const noexcept override { return time - tracked_.seen(); }
  [[nodiscard]] MasterLag lag() const noexcept override {
    return {tracked_.lag(), tracked_.estimate().v};
  }
  [[nodiscard]] std::span<const MasterSample> taken() const noexcept override {
    return {taken_.data(), count_};
  }

  /// The estimate of the sender's clock.
  [[nodiscard]] const ClockOffset& clock() const { return clock_; }
  /// Options of the filter.
  [[nodiscard]] const TrackerSpec& spec() const { return tracked_.spec(); }

 private:
  static constexpr std::size_t most = 64;  // greatest number of samples in a cycle
  Ring<MasterSample, most> samples_;
  std::array<MasterSample, most> taken_{};
  std::size_t count_ = 0;
  ClockOffset clock_;
  Tracked tracked_;
};

}  // namespace jounce
