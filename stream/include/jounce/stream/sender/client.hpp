// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "jounce/stream/sender/ask.hpp"
#include "jounce/stream/sender/driver.hpp"
#include "jounce/stream/sender/outcome.hpp"

namespace jounce {

struct ClientOptions {
  std::optional<wire::Key> key{};                ///< key of the executor; nullopt: none
  Nanos patience = std::chrono::seconds(2);      ///< for one call
  Nanos repeat = std::chrono::milliseconds(20);  ///< repeat of a command, until it is answered
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

  CallOutcome enable() { return command(command::Enable{}); }
  CallOutcome disable() { return command(command::Disable{}); }
  CallOutcome reset() { return command(command::Reset{}); }
  CallOutcome set_position(double position, bool relative = false);
  /// Sets the present position as home, with this value, without motion.
  CallOutcome home(double position);
  /// Searches for home by a method of CiA 402; 0 and NaN: as configured for the axis. Accepted: the
  /// search has begun.
  CallOutcome search_home(int method = 0, double offset = as_configured);
  CallOutcome hold() { return command(command::Hold{}); }
  CallOutcome resume() { return command(command::Resume{}); }
  CallOutcome override_(double factor);

  /// `direction` of a rotary axis: 1 or -1, 0 the shorter way.
  CallOutcome move_absolute(double position, const MoveDynamics& dynamics = {}, int direction = 0);
  CallOutcome move_relative(double distance, const MoveDynamics& dynamics = {});
  CallOutcome move_additive(double distance, const MoveDynamics& dynamics = {});
  /// dynamics.velocity: the greatest difference to the motion below.
  CallOutcome move_superimposed(double distance, const MoveDynamics& dynamics = {});
  /// `velocity` is signed, 0: to rest.
  CallOutcome move_velocity(double velocity, const RampDynamics& dynamics = {});
  /// The same as a hold-to-run jog: it stops when this session ends, or is silent for 0.2 s. beat()
  /// keeps it running.
  CallOutcome jog(double velocity, const RampDynamics& dynamics = {});
  /// Sends a heartbeat.
  CallOutcome beat() { return tell(wire::Heartbeat{}); }
  CallOutcome halt(const StopDynamics& dynamics = {});
  CallOutcome stop(wire::StopMode mode = wire::StopMode::stop);

  CallOutcome gear_in(std::int32_t numerator, std::int32_t denominator,
                      const RampDynamics& dynamics = {});
  CallOutcome gear_in_pos(std::int32_t numerator, std::int32_t denominator, double master_sync,
                          double slave_sync, double master_start_distance,
                          bool avoid_reversal = false);
  CallOutcome gear_out() { return command(command::GearOut{}); }
  CallOutcome cam_out() { return command(command::CamOut{}); }

  /// Sends any command to the axis. `at`: its tick in the executor, -1: the next one. Throws
  /// InputError for a value out of range.
  CallOutcome command(const ClientCommand& command, std::int64_t at = -1);

  /// Sends any message of a client, in the present session or in a new one. A heartbeat keeps it.
  CallOutcome tell(wire::Body body);

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
