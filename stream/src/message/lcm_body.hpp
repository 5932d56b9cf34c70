// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

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

/// Converts the fields of each message to and from the generated type. wire.cpp handles the
/// envelope and the checksum.
namespace jounce::wire {

/// A Command that has too many fields for command_t.
struct PathCommand : Command {};
/// True if the command travels as path_command_t.
bool is_path_command(const Command& command);

// Throws InputError for a value that does not fit the wire.
void put(const Header& from, jounce_lcm::header_t& to);
void put(const Chunk& from, jounce_lcm::chunk_t& to);
void put(const Arm& from, jounce_lcm::arm_t& to);
void put(const Start& from, jounce_lcm::start_t& to);
void put(const Stop& from, jounce_lcm::stop_t& to);
void put(const Heartbeat& from, jounce_lcm::heartbeat_t& to);
void put(const Ack& from, jounce_lcm::ack_t& to);
void put(const Reply& from, jounce_lcm::reply_t& to);
void put(const Status& from, jounce_lcm::status_t& to);
void put(const Command& from, jounce_lcm::command_t& to);
void put(const PathCommand& from, jounce_lcm::path_command_t& to);
void put(const Queue& from, jounce_lcm::queue_t& to);
void put(const Rows& from, jounce_lcm::rows_t& to);
void put(const QueueAck& from, jounce_lcm::queue_ack_t& to);
void put(const Master& from, jounce_lcm::master_t& to);
void put(const Event& from, jounce_lcm::event_t& to);
void put(const MasterStatus& from, jounce_lcm::master_status_t& to);
void put(const Claim& from, jounce_lcm::claim_t& to);
void put(const GroupStatus& from, jounce_lcm::group_status_t& to);

// Returns false if a field is out of its range.
bool get(const jounce_lcm::header_t& from, Header& to);
bool get(const jounce_lcm::chunk_t& from, Chunk& to);
bool get(const jounce_lcm::arm_t& from, Arm& to);
bool get(const jounce_lcm::start_t& from, Start& to);
bool get(const jounce_lcm::stop_t& from, Stop& to);
bool get(const jounce_lcm::heartbeat_t& from, Heartbeat& to);
bool get(const jounce_lcm::ack_t& from, Ack& to);
bool get(const jounce_lcm::reply_t& from, Reply& to);
bool get(const jounce_lcm::status_t& from, Status& to);
bool get(const jounce_lcm::command_t& from, Command& to);
bool get(const jounce_lcm::path_command_t& from, PathCommand& to);
bool get(const jounce_lcm::queue_t& from, Queue& to);
bool get(const jounce_lcm::rows_t& from, Rows& to);
bool get(const jounce_lcm::queue_ack_t& from, QueueAck& to);
bool get(const jounce_lcm::master_t& from, Master& to);
bool get(const jounce_lcm::event_t& from, Event& to);
bool get(const jounce_lcm::master_status_t& from, MasterStatus& to);
bool get(const jounce_lcm::claim_t& from, Claim& to);
bool get(const jounce_lcm::group_status_t& from, GroupStatus& to);

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
