// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "jounce/command/detail/command_table.hpp"
#include "jounce/stream/message/message.hpp"

#include "jounce_lcm/ack_t.hpp"
#include "jounce_lcm/arm_t.hpp"
#include "jounce_lcm/chunk_t.hpp"
#include "jounce_lcm/claim_t.hpp"
#include "jounce_lcm/command_t.hpp"
#include "jounce_lcm/coupling_t.hpp"
#include "jounce_lcm/event_t.hpp"
#include "jounce_lcm/group_status_t.hpp"
#include "jounce_lcm/header_t.hpp"
#include "jounce_lcm/heartbeat_t.hpp"
#include "jounce_lcm/master_status_t.hpp"
#include "jounce_lcm/master_t.hpp"
#include "jounce_lcm/path_command_t.hpp"
#include "jounce_lcm/queue_ack_t.hpp"
#include "jounce_lcm/queue_t.hpp"
#include "jounce_lcm/reply_t.hpp"
#include "jounce_lcm/rows_t.hpp"
#include "jounce_lcm/start_t.hpp"
#include "jounce_lcm/status_t.hpp"
#include "jounce_lcm/stop_t.hpp"

/// The generated type of each message. wire.cpp handles the envelope and the checksum.
namespace jounce::wire {

/// A Command that has too many fields for command_t.
struct PathCommand : Command {};
/// True if the command travels as path_command_t.
inline bool is_path_command(const Command& command) {
  constexpr std::size_t plain = std::extent_v<decltype(jounce_lcm::command_t::value)>;
  static_assert(std::extent_v<decltype(jounce_lcm::path_command_t::value)> == most_fields);
  return info(command.kind).fields.size() > plain;
}

template <class Body>
struct LcmOf;
template <>
struct LcmOf<Header> : std::type_identity<jounce_lcm::header_t> {};
template <>
struct LcmOf<Chunk> : std::type_identity<jounce_lcm::chunk_t> {};
template <>
struct LcmOf<Arm> : std::type_identity<jounce_lcm::arm_t> {};
template <>
struct LcmOf<Start> : std::type_identity<jounce_lcm::start_t> {};
template <>
struct LcmOf<Stop> : std::type_identity<jounce_lcm::stop_t> {};
template <>
struct LcmOf<Heartbeat> : std::type_identity<jounce_lcm::heartbeat_t> {};
template <>
struct LcmOf<Ack> : std::type_identity<jounce_lcm::ack_t> {};
template <>
struct LcmOf<Reply> : std::type_identity<jounce_lcm::reply_t> {};
template <>
struct LcmOf<Status> : std::type_identity<jounce_lcm::status_t> {};
template <>
struct LcmOf<Command> : std::type_identity<jounce_lcm::command_t> {};
template <>
struct LcmOf<PathCommand> : std::type_identity<jounce_lcm::path_command_t> {};
template <>
struct LcmOf<Queue> : std::type_identity<jounce_lcm::queue_t> {};
template <>
struct LcmOf<Rows> : std::type_identity<jounce_lcm::rows_t> {};
template <>
struct LcmOf<QueueAck> : std::type_identity<jounce_lcm::queue_ack_t> {};
template <>
struct LcmOf<Master> : std::type_identity<jounce_lcm::master_t> {};
template <>
struct LcmOf<Event> : std::type_identity<jounce_lcm::event_t> {};
template <>
struct LcmOf<MasterStatus> : std::type_identity<jounce_lcm::master_status_t> {};
template <>
struct LcmOf<Claim> : std::type_identity<jounce_lcm::claim_t> {};
template <>
struct LcmOf<GroupStatus> : std::type_identity<jounce_lcm::group_status_t> {};

}  // namespace jounce::wire
