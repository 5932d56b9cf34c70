// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/claim.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <variant>

#include "jounce/stream/transport/link.hpp"

namespace jounce {
namespace {

constexpr std::size_t most_claim_answers =
    256;  // between two polls: without a key any sender may ask

}  // namespace

Claim::Claim(std::vector<std::string> names, std::int64_t boot, ClaimOptions options)
    : names_(std::move(names)), boot_(boot), options_(options) {
  assert(boot > 0 && options.asked > 0);
}

void Claim::receive(const wire::Message& message, Nanos /*now*/) {
  const auto* const claim = std::get_if<wire::Claim>(&message.body);
  if (claim == nullptr || claim->boot == boot_ || lost_) return;
  if (std::find(names_.begin(), names_.end(), message.executor) == names_.end()) return;
  if (claim->rival == 0 && outgoing_.size() < most_claim_answers)
    outgoing_.push_back({message.executor, 0, wire::Claim{boot_, claim->boot, up_}});
  const bool wins = claim->up != up_ ? claim->up : claim->boot < boot_;
  if (claim->rival == boot_ && wins) lost_ = message.executor;
}

std::vector<wire::Message> Claim::poll(Nanos now) {
  const Nanos pause = up_ ? options_.again : options_.repeat;
  if (lost_ || (asked_at_ && now - *asked_at_ < pause)) return std::exchange(outgoing_, {});
  if (asked_ == options_.asked) up_ = true;
  ask(now);
  return std::exchange(outgoing_, {});
}

void Claim::ask(Nanos now) {
  asked_at_ = now;
  if (!up_) ++asked_;
  for (const std::string& name : names_)
    outgoing_.push_back({name, 0, wire::Claim{.boot = boot_, .rival = 0, .up = up_}});
}

bool claim_names(Transport& link, Claim& claim, const std::optional<wire::Key>& key,
                 const Clock& clock) {
  constexpr Nanos turn = std::chrono::milliseconds(5);
  for (const std::string& name : claim.names())
    link.subscribe(wire::channel(name, wire::Lane::claim), queue_capacity);
  Rejects rejects;
  // All messages that arrived before the judged instant have been received: a delayed process does
  // not mistake unread answers for silence.
  for (Nanos now = clock(); !claim.up() && !claim.lost();) {
    for (const auto& message : claim.poll(now)) send_message(link, message, key);
    now = clock();
    drain(link, turn, key, rejects,
          [&](const wire::Message& message) { claim.receive(message, clock()); });
  }
  for (const auto& message : claim.poll(clock())) send_message(link, message, key);
  return !claim.lost();
}

}  // namespace jounce
