// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>

#include "jounce/stream/sender/ask.hpp"
#include "jounce/stream/sender/driver.hpp"

namespace jounce {

/// Outcome of a call.
struct CallOutcome {
  StreamError error = StreamError::none;  ///< no_answer, command_timeout, restarted or refused
  wire::Refusal refusal = wire::Refusal::none;
  std::int32_t cause = 0;  ///< the axis's number of the cause
  std::string reason{};    ///< in words; may be empty

  [[nodiscard]] bool ok() const { return error == StreamError::none; }
};

struct ClientOptions {
  std::optional<wire::Key> key{};                ///< key of the executor; nullopt: none
  Nanos patience = std::chrono::seconds(2);      ///< for one call
  Nanos repeat = std::chrono::milliseconds(20);  ///< repeat of a command, until it is answered
};

/// Dynamics of a motion, u/s, u/s^2, u/s^3, > 0. NaN: the limit of the axis.
struct Pacing {
  static constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
  double velocity = not_given;
  double acceleration = not_given;
  double deceleration = not_given;
  double jerk = not_given;
};

/// Commands an axis of an executor, one call after another, like the function blocks of PLCopen.
///
///     Client client(link, "feeder");
///     if (const auto outcome = client.enable(); !outcome.ok()) return outcome.reason;
///     client.move_absolute(120, {.velocity = 200});   // accepted: the axis moves
///     client.override_(0.5);
///     client.release();                               // the motion continues
///
/// Each call returns once the axis has accepted or rejected it. It throws only InputError, for a
/// value out of range for any axis, and TransportError. The first call begins a session, which owns
/// the axis; while another session owns it, calls are rejected as busy. After a second without a
/// call the axis is free again, and the next call begins another session.
class Client {
 public:
  /// Subscribes. The link must outlive the client. Throws InputError for a bad name.
  Client(Transport& link, std::string executor, ClientOptions options = {},
         Clock clock = steady_now);

  CallOutcome enable() { return order(wire::OrderKind::enable); }
  CallOutcome disable() { return order(wire::OrderKind::disable); }
  CallOutcome reset() { return order(wire::OrderKind::reset); }
  CallOutcome set_position(double position, bool relative = false);
  /// Sets the present position as home, with this value, without motion.
  CallOutcome home(double position);
  /// Searches for home by a method of CiA 402; 0 and NaN: as configured for the axis. Accepted: the
  /// search has begun.
  CallOutcome search_home(int method = 0, double offset = Pacing::not_given);
  CallOutcome hold() { return order(wire::OrderKind::hold); }
  CallOutcome resume() { return order(wire::OrderKind::resume); }
  CallOutcome override_(double factor);

  /// `direction` of a rotary axis: 1 or -1, 0 the shorter way.
  CallOutcome move_absolute(double position, const Pacing& pacing = {}, int direction = 0);
  CallOutcome move_relative(double distance, const Pacing& pacing = {});
  CallOutcome move_additive(double distance, const Pacing& pacing = {});
  /// pacing.velocity: the greatest difference to the motion below.
  CallOutcome move_superimposed(double distance, const Pacing& pacing = {});
  /// `velocity` is signed, 0: to rest; pacing.velocity is ignored.
  CallOutcome move_velocity(double velocity, const Pacing& pacing = {});
  /// The same as a hold-to-run jog: it stops when this session ends, or is silent for 0.2 s. beat()
  /// keeps it running.
  CallOutcome jog(double velocity, const Pacing& pacing = {});
  /// Sends a heartbeat.
  CallOutcome beat() { return tell(wire::Heartbeat{}); }
  CallOutcome halt(const Pacing& pacing = {});
  CallOutcome stop(wire::StopMode mode = wire::StopMode::stop);

  CallOutcome gear_in(std::int32_t numerator, std::int32_t denominator, const Pacing& pacing = {});
  CallOutcome gear_in_pos(std::int32_t numerator, std::int32_t denominator, double master_sync,
                          double slave_sync, double master_start_distance,
                          bool avoid_reversal = false);
  CallOutcome gear_out() { return order(wire::OrderKind::gear_out); }
  CallOutcome cam_out() { return order(wire::OrderKind::cam_out); }

  /// Sends any order.
  CallOutcome order(const wire::Order& order);
  /// Sends any order by its values (wire::values); `at`: its tick in the executor, -1: the next
  /// one.
  CallOutcome order(wire::OrderKind kind, std::initializer_list<double> given = {},
                    std::int64_t at = -1);

  /// Sends any command, in the present session or in a new one. A heartbeat keeps it.
  CallOutcome tell(wire::Body command);

  /// Ends the session; a motion continues.
  CallOutcome release();

  [[nodiscard]] std::int64_t session() const { return session_; }  ///< 0: none yet

 private:
  friend class StaticQueue;

  CallOutcome open();
  void send(wire::Body body);
  [[nodiscard]] std::optional<wire::Message> hear(Nanos timeout);
  CallOutcome ask(const wire::Body& body);

  Transport& link_;
  std::string executor_;
  ClientOptions options_;
  Clock clock_;
  Rejects rejects_;
  CommandSlot slot_;
  std::int64_t session_ = 0;
  std::int64_t challenge_ = 0;
  std::int64_t boot_ = 0;
};

}  // namespace jounce
