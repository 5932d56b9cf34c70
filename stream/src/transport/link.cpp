// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/transport/link.hpp"

#include <numeric>
#include <random>
#include <utility>
#include <variant>

namespace jounce {

std::size_t Rejects::total() const {
  return std::accumulate(by_reason.begin(), by_reason.end(), std::size_t{0});
}

std::optional<wire::Message> next_message(Transport& link, Nanos timeout, Rejects& rejects,
                                          const std::optional<wire::Key>& key) {
  const auto packet = link.receive(timeout);
  if (!packet) return std::nullopt;
  auto decoded = wire::decode(packet->bytes, key);
  if (const auto* reject = std::get_if<wire::Reject>(&decoded)) {
    ++rejects.by_reason[static_cast<std::size_t>(*reject)];
    return std::nullopt;
  }
  return std::get<wire::Message>(std::move(decoded));
}

void drain(Transport& link, Nanos timeout, const std::optional<wire::Key>& key, Rejects& rejects,
           const std::function<void(const wire::Message&)>& take) {
  constexpr int most_at_once = 256;  // packets between two iterations of the protocol
  for (int i = 0; i < most_at_once; ++i) {
    const std::size_t rejected = rejects.total();
    const auto message = next_message(link, i == 0 ? timeout : Nanos{}, rejects, key);
    if (message) {
      take(*message);
    } else if (rejects.total() == rejected) {
      return;
    }
  }
}

void send_message(Transport& link, const wire::Message& message,
                  const std::optional<wire::Key>& key) {
  link.send(wire::channel(message.executor, wire::lane(message.body)), wire::encode(message, key));
}

std::int64_t random_id() {
  std::random_device device;
  const std::uint64_t high = device();
  const std::uint64_t bits = high << 32U | device();
  return static_cast<std::int64_t>(bits >> 1U | 1U);
}

}  // namespace jounce
