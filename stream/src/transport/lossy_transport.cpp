// SPDX-License-Identifier: Apache-2.0
#include "stream/src/transport/lossy_transport.hpp"

#include <algorithm>
#include <utility>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

void require_share(const char* key, double share) {
  if (!(share >= 0 && share <= 1)) throw InputError(key, share, "must be from 0 to 1");
}

}  // namespace

LossyTransport::LossyTransport(Transport& link, const LossSpec& spec, Clock clock)
    : link_(link), spec_(spec), clock_(std::move(clock)), state_(spec.seed), begin_(clock_()) {
  require_share("lost", spec.lost);
  require_share("doubled", spec.doubled);
  require_share("corrupted", spec.corrupted);
  require_share("delayed", spec.delayed);
  for (const Partition& partition : spec.partitions) {
    if (partition.to < partition.from)
      throw InputError("partition.to", std::to_string(partition.to.count()),
                       "ns must not be before its `from`");
  }
}

/// Uniform in [0, 1): SplitMix64 (Steele, Lea, Flood 2014), the same on every machine.
double LossyTransport::draw() {
  state_ += 0x9E3779B97F4A7C15U;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-53;
}

bool LossyTransport::cut(Partition::Way way) const {
  const Nanos now = clock_() - begin_;
  return std::any_of(spec_.partitions.begin(), spec_.partitions.end(), [&](const Partition& p) {
    return p.from <= now && now < p.to && (p.way == Partition::Way::both || p.way == way);
  });
}

void LossyTransport::mistreat(Packet packet, Partition::Way way) {
  if (cut(way)) return;
  Queue& queue = way == Partition::Way::out ? out_ : in_;
  if (draw() < spec_.lost) return;
  if (draw() < spec_.corrupted && !packet.bytes.empty()) {
    const auto bits = static_cast<double>(packet.bytes.size() * 8);
    const auto bit = static_cast<std::size_t>(draw() * bits);
    packet.bytes[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
  }
  const int copies = draw() < spec_.doubled ? 2 : 1;
  for (int i = 0; i < copies; ++i) {
    Held held{clock_(), packet};
    if (draw() < spec_.delayed) {
      held.until +=
          Nanos(static_cast<Nanos::rep>(draw() * static_cast<double>(spec_.delay.count())));
    }
    const auto place = std::find_if(queue.begin(), queue.end(),
                                    [&](const Held& other) { return other.until > held.until; });
    queue.insert(place, std::move(held));
  }
}

std::optional<Packet> LossyTransport::take_due(Queue& queue, Nanos now) {
  if (queue.empty() || queue.front().until > now) return std::nullopt;
  Packet packet = std::move(queue.front().packet);
  queue.pop_front();
  return packet;
}

void LossyTransport::pass_on_due() {
  while (const auto packet = take_due(out_, clock_())) link_.send(packet->channel, packet->bytes);
}

void LossyTransport::subscribe(const std::string& channel, int capacity) {
  link_.subscribe(channel, capacity);
}

void LossyTransport::send(const std::string& channel, std::span<const std::byte> bytes) {
  mistreat({channel, {bytes.begin(), bytes.end()}}, Partition::Way::out);
  pass_on_due();
}

std::optional<Packet> LossyTransport::receive(Nanos timeout) {
  pass_on_due();
  while (auto arrived = link_.receive(Nanos{})) mistreat(*std::move(arrived), Partition::Way::in);
  if (auto packet = take_due(in_, clock_())) return packet;

  Nanos wait = timeout;
  for (const Queue* queue : {&out_, &in_})
    if (!queue->empty()) wait = std::clamp(queue->front().until - clock_(), Nanos{}, wait);
  if (auto arrived = link_.receive(wait)) mistreat(*std::move(arrived), Partition::Way::in);
  pass_on_due();
  return take_due(in_, clock_());
}

}  // namespace jounce
