// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A period during which a link is cut: [from, to) since its construction. Packets sent then are
/// lost.
struct Partition {
  enum class Way { both, out, in };
  Nanos from{};
  Nanos to{};
  Way way = Way::both;  ///< `out`: packets of this side are lost, but it receives
};

/// Faults of packets, in each direction. Shares are probabilities from 0 to 1.
struct LossSpec {
  std::uint64_t seed = 1;
  double lost = 0;
  double doubled = 0;
  double corrupted = 0;  ///< one bit of it inverted
  double delayed = 0;    ///< for up to `delay`: later ones overtake it
  Nanos delay = std::chrono::milliseconds(5);
  std::vector<Partition> partitions = {};
};

/// A degraded link, in both directions; the seed makes it reproducible. The link below and the
/// clock must outlive it.
class LossyTransport : public Transport {
 public:
  /// Throws InputError for a share out of range, or a partition that ends before it begins.
  LossyTransport(Transport& link, const LossSpec& spec, Clock clock);

  void subscribe(const std::string& channel, int capacity) override;
  void send(const std::string& channel, std::span<const std::byte> bytes) override;
  std::optional<Packet> receive(Nanos timeout) override;

 private:
  struct Held {
    Nanos until{};
    Packet packet;
  };
  using Queue = std::list<Held>;  // in the order of delivery

  double draw();
  [[nodiscard]] bool cut(Partition::Way way) const;
  void mistreat(Packet packet, Partition::Way way);
  static std::optional<Packet> take_due(Queue& queue, Nanos now);
  void pass_on_due();

  Transport& link_;
  LossSpec spec_;
  Clock clock_;
  std::uint64_t state_;
  Nanos begin_;
  Queue out_, in_;
};

}  // namespace jounce
