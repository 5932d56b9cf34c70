// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <list>
#include <vector>

#include "jounce/stream/transport/transport.hpp"

namespace jounce {

/// A period in which a link is interrupted. `from` and `to` count from the construction of the
/// link. Packets sent in this period are lost.
struct Partition {
  /// Direction of the loss.
  enum class Way { both, out, in };
  Nanos from{};  ///< start of the period
  Nanos to{};    ///< end of the period
  /// `out`: packets from this side are lost; `in`: packets to this side; `both`: all packets.
  Way way = Way::both;
};

/// Faults of a link, in both directions. Shares are probabilities from 0 to 1.
struct LossSpec {
  std::uint64_t seed = 1;  ///< seed of the random numbers
  double lost = 0;         ///< share of packets that are lost
  double doubled = 0;      ///< share of packets that are sent twice
  double corrupted = 0;    ///< share of packets in which one bit is inverted
  /// Share of packets that are delayed by up to `delay`; later packets overtake them.
  double delayed = 0;
  Nanos delay = std::chrono::milliseconds(5);  ///< greatest delay
  std::vector<Partition> partitions = {};      ///< interruptions
};

/// A link with simulated faults in both directions. The same seed gives the same faults. `link` and
/// `clock` must outlive the object.
class LossyTransport : public Transport {
 public:
  /// Throws InputError for a share out of range, and for an interruption that ends before it
  /// begins.
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
