// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/session.hpp"

#include <algorithm>
#include <utility>

namespace jounce {
namespace {

constexpr std::size_t remembered_sessions = 16;

}  // namespace

bool opens_session(const wire::Body& body) {
  const auto* const heartbeat = std::get_if<wire::Heartbeat>(&body);
  return (heartbeat != nullptr && !heartbeat->release) ||
         std::holds_alternative<wire::Header>(body) || std::holds_alternative<wire::Queue>(body);
}

Refused Session::bars(const wire::Message& message, std::int64_t challenge) const {
  const std::int64_t sender = message.session;
  if (sender == id_ && message.challenge == challenge) return {};
  // The last owner may stop its motion even after its session, until there is another owner.
  if (is_of_last_owner(message) && std::holds_alternative<wire::Stop>(message.body)) return {};
  const auto ended = std::find_if(ended_.begin(), ended_.end(),
                                  [&](const Ended& one) { return one.id == sender; });
  if (ended != ended_.end())
    return {wire::Refusal::session_ended, ended->reason, static_cast<std::int32_t>(ended->cause)};
  if (!is_free() && sender != id_)
    return {wire::Refusal::busy, "the axis belongs to another session"};
  if (message.challenge != challenge) return {wire::Refusal::stale_challenge, {}};
  if (!opens_session(message.body)) return {wire::Refusal::unknown_session, {}};
  return {};
}

bool Session::is_of_last_owner(const wire::Message& message) const {
  return is_free() && message.session == owner_ && message.challenge == challenge_;
}

void Session::open(std::int64_t id, std::int64_t challenge) {
  id_ = owner_ = id;
  challenge_ = challenge;
}

bool Session::is_silent(Nanos now) const {
  return !is_free() && now - received_ > (holds_ ? timeouts_.hold : timeouts_.usual);
}

void Session::end(std::string reason, Cause cause) {
  ended_.push_back({id_, std::move(reason), cause});
  if (ended_.size() > remembered_sessions) ended_.pop_front();
  id_ = 0;
  holds_ = false;
}

void Session::stopped(std::int64_t id) {
  for (Ended& ended : ended_)
    if (ended.id == id) ended.cause = Cause::stopped;
}

}  // namespace jounce
