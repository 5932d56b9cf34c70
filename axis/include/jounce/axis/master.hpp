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

/// A measured position from an external source, with the sender's time.
struct MasterSample {
  std::int64_t stamp_ns = 0;  ///< time of the measurement, by the sender's clock
  std::int32_t clock = 0;     ///< a new number: another clock, or the same one restarted
  double received = 0;        ///< s: time of arrival, by the clock of at()
  double position = 0;        ///< m
  bool valid = true;          ///< the sender reports a valid position
};

/// The position of a master in each cycle, which axes follow. A master can also be the setpoint of
/// another axis; the machine (machine.hpp) then passes it on itself.
///
///     ExternalMaster line({.velocity = 3, .acceleration = 20});    // m/s, m/s^2
///     line.receive({.stamp_ns = ..., .received = now, .position = 1.25});  // communication thread
///     const Jet x = line.at(tick * period);                                // in each cycle
///     if (std::isnan(x[0])) ...                                            // none, or lost
class Master {
 public:
  Master() = default;
  virtual ~Master() = default;
  Master(const Master&) = delete;
  Master& operator=(const Master&) = delete;

  /// [x, x', x'', x'''] at `time`; m, m/s, ... `time`, s, must ascend from call to call. x is NaN
  /// if the master is lost. Does not allocate, wait or throw.
  virtual Jet at(double time) noexcept = 0;
  /// Age of the measurement, s; NaN: no measurement; 0: computed.
  [[nodiscard]] virtual double age(double /*time*/) const noexcept { return 0; }
  /// The external inputs that the last at() was the first to use. Given the same inputs before the
  /// same call of at(), another object of the same class returns the same result, bit for bit.
  [[nodiscard]] virtual std::span<const MasterSample> taken() const noexcept { return {}; }
};

/// The value of a master in one cycle.
struct MasterSight {
  std::int64_t tick = -1;
  Jet at = {std::numeric_limits<double>::quiet_NaN(), 0, 0, 0};  ///< like Master::at()
  double age = std::numeric_limits<double>::quiet_NaN();         ///< like Master::age()

  [[nodiscard]] bool lost() const { return std::isnan(at[0]); }
};

/// A virtual master: a table over time from `start` on. Before `start` it stands at its first
/// point; after the end of the table it stands at the last point or repeats, as the table defines.
class TableMaster final : public Master {
 public:
  /// Throws InputError "axis" for a table that is not over time.
  explicit TableMaster(std::shared_ptr<const Table> table, double start = 0);
  Jet at(double time) noexcept override;

 private:
  std::shared_ptr<const Table> table_;
  double start_;
};

/// An encoder that is read in the cyclic thread: filters noise and quantization (tracker.hpp).
class EncoderMaster final : public Master {
 public:
  /// `position` returns the position of the encoder, m, or NaN: no reading; each at() calls it.
  /// After too long without a reading the master is lost. Like at(), it must not allocate, wait or
  /// throw. Without `position`, call read() in each cycle.
  explicit EncoderMaster(const TrackerSpec& spec, std::function<double()> position = {})
      : position_(std::move(position)), tracked_(spec) {}
  /// The reading of this cycle, m; call it before at(). After too long without a reading (or with
  /// NaN) the master is lost.
  void read(double time, double position) noexcept;
  Jet at(double time) noexcept override;
  [[nodiscard]] double age(double time) const noexcept override { return time - tracked_.seen(); }
  /// The reading that the last at() used, if any: its position and, in `received`, its time.
  [[nodiscard]] std::span<const MasterSample> taken() const noexcept override {
    return {&taken_, was_read_ ? 1U : 0U};
  }
  [[nodiscard]] const TrackerSpec& spec() const { return tracked_.spec(); }

 private:
  std::function<double()> position_;
  Tracked tracked_;
  MasterSample reading_, taken_;
  bool read_ = false;      // since the last at()
  bool was_read_ = false;  // before the last at()
};

/// Estimate of the sender's clock without a round trip. received - stamp is the offset of the
/// clocks plus the transit time of the sample. Its recent minimum is therefore the offset plus the
/// least delay: jitter can only increase it. The estimate uses the minimum of each half of the
/// window and moves towards the smaller one by at most `slew`, so that the master does not step. It
/// steps at the first sample, and when the error exceeds `step`: then one of the clocks was
/// changed.
///
///     (1)  offset = least of received - stamp over window/2 to window
///
/// The least delay cannot be measured: give it as TrackerSpec::latency if it is available.
struct ClockOffset {
  double window = 10;  ///< s: long enough for one quick sample, short against the drift of quartz
  double slew = 1e-3;  ///< s/s; quartz drifts by less than 1e-4
  double step = 0.25;  ///< s
  double offset = 0;   ///< s, of stamp - base
  std::int64_t base = 0;  ///< ns: the first stamp, to which the others are relative
  bool known = false;

  /// Time of the sample by the local clock, s. `same` is false if the estimate was restarted.
  double local(const MasterSample& sample, bool& same) noexcept;

  std::int32_t clock = 0;
  double least_before = 0, least_now = 0;  ///< least offset of both halves
  double half_since = 0, last = 0;         ///< s
};

/// An external master, over a bus. Samples may be late, lost or duplicated, and may jitter; the
/// master is extrapolated within its limits. It is lost after `longest_age` without a sample.
class ExternalMaster final : public Master {
 public:
  explicit ExternalMaster(const TrackerSpec& spec) : tracked_(spec) {}
  /// Called by the communication thread. False: not stored, since the cycle has not yet taken the
  /// last 64.
  bool receive(const MasterSample& sample) noexcept { return samples_.push(sample); }
  /// Called by the cyclic thread.
  Jet at(double time) noexcept override;
  [[nodiscard]] double age(double time) const noexcept override { return time - tracked_.seen(); }
  [[nodiscard]] std::span<const MasterSample> taken() const noexcept override {
    return {taken_.data(), count_};
  }

  [[nodiscard]] const ClockOffset& clock() const { return clock_; }
  [[nodiscard]] const TrackerSpec& spec() const { return tracked_.spec(); }

 private:
  static constexpr std::size_t most = 64;  // most samples in a cycle
  Ring<MasterSample, most> samples_;
  std::array<MasterSample, most> taken_{};
  std::size_t count_ = 0;
  ClockOffset clock_;
  Tracked tracked_;
};

}  // namespace jounce
