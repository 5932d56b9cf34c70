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
  std::int32_t cause = 0;  ///< the axis's own number where it refused
  std::string reason{};    ///< in words; may be empty

  [[nodiscard]] bool ok() const { return error == StreamError::none; }
};

struct ClientOptions {
  std::optional<wire::Key> key{};                ///< the executor's; none: it has none
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
///     client.release();                               // the motion goes on
///
/// Each call returns once the axis has accepted or refused; it never throws except for a value that no
/// axis can take (InputError) and TransportError. The first one begins a session, which owns the
/// axis; while another one owns it, calls are refused as busy. After a second without a call the
/// axis is free again, and the next call begins another session.
class Client {
 public:
  /// Subscribes. The link must outlive the client. Throws InputError for a bad name.
  Client(Transport& link, std::string executor, ClientOptions options = {},
         Clock clock = steady_now);

  CallOutcome enable() { return order(wire::OrderKind::enable); }
  CallOutcome disable() { return order(wire::OrderKind::disable); }
  CallOutcome reset() { return order(wire::OrderKind::reset); }
  CallOutcome set_position(double position, bool relative = false);
  /// Nothing moves: where the axis stands is its home, and has this position.
  CallOutcome home(double position);
  /// Searches for home by a method of CiA 402, 0 and NaN: as the axis is configured. Accepted: it has begun.
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
  /// `velocity` is signed, 0: to rest; pacing.velocity has no meaning.
  CallOutcome move_velocity(double velocity, const Pacing& pacing = {});
  /// The same as a hold-to-run jog: it stops when this session ends, or is silent for 0.2 s. beat() keeps it.
  CallOutcome jog(double velocity, const Pacing& pacing = {});
  /// A heartbeat.
  CallOutcome beat() { return tell(wire::Heartbeat{}); }
  CallOutcome halt(const Pacing& pacing = {});
  CallOutcome stop(wire::StopMode mode = wire::StopMode::stop);

  CallOutcome gear_in(std::int32_t numerator, std::int32_t denominator, const Pacing& pacing = {});
  CallOutcome gear_in_pos(std::int32_t numerator, std::int32_t denominator, double master_sync,
                          double slave_sync, double master_start_distance,
                          bool avoid_reversal = false);
  CallOutcome gear_out() { return order(wire::OrderKind::gear_out); }
  CallOutcome cam_out() { return order(wire::OrderKind::cam_out); }

  /// Any order.
  CallOutcome order(const wire::Order& order);
  /// Any order by its values (wire::values); `at`: the executor's tick at which it is obeyed, -1: the next one.
  CallOutcome order(wire::OrderKind kind, std::initializer_list<double> given = {},
                    std::int64_t at = -1);

  /// Any command, in the session that is there or else in a new one. A heartbeat keeps it.
  CallOutcome tell(wire::Body command);

  /// Ends the session; a motion goes on.
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
