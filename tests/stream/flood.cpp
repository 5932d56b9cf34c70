// SPDX-License-Identifier: Apache-2.0
// Floods a bus: flood URL RATE EXECUTOR [SECONDS]. Of all messages a second, most are foreign
// (channels and magic numbers of other programs), and every hundredth is malformed on a channel of
// this executor: cut short, too long, random, or with one bit changed. Run it in a namespace of its
// own, beside an executor. A signal ends it; it then prints the number of sent messages.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <time.h>

#include "jounce/stream/message/wire.hpp"
#include "jounce/stream/transport/open_transport.hpp"

#include "support/random.hpp"

namespace {

using namespace jounce;

volatile std::sig_atomic_t over = 0;

wire::Bytes malformed(jounce::test::Random& random, const wire::Bytes& whole) {
  wire::Bytes bytes = whole;
  const auto somewhere = [&] {
    return static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())));
  };
  switch (random.below(4)) {
    case 0:
      bytes.resize(somewhere());
      break;
    case 1:
      bytes.resize(bytes.size() + 1 + somewhere());
      break;
    case 2:
      for (auto& byte : bytes) byte = static_cast<std::byte>(random.below(256));
      break;
    default:
      bytes[somewhere()] ^= static_cast<std::byte>(1 << random.below(8));
  }
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  const int rate = std::atoi(arguments[2]);
  const std::string executor = arguments[3];
  const double seconds = count > 4 ? std::atof(arguments[4]) : 60;
  std::signal(SIGTERM, [](int) { over = 1; });
  std::signal(SIGINT, [](int) { over = 1; });

  const auto link = open_transport(arguments[1]);
  jounce::test::Random random(1);
  const wire::Bytes start = wire::encode({executor, 1, wire::Start{.command = 1}});
  const wire::Bytes foreign(64, std::byte{0x55});
  const Nanos begin = steady_now();
  long sent = 0;
  double elapsed = 0;
  while (over == 0 && elapsed < seconds) {
    const long due = static_cast<long>(elapsed * rate);
    for (; sent < due && over == 0; ++sent) {
      if (sent % 100 != 0) {
        link->send("FOREIGN." + std::to_string(sent % 50), foreign);
      } else {
        const auto lane = sent % 200 == 0 ? wire::Lane::command : wire::Lane::table;
        link->send(wire::channel(executor, lane), malformed(random, start));
      }
    }
    const timespec nap{0, 500'000};
    nanosleep(&nap, nullptr);
    elapsed = std::chrono::duration<double>(steady_now() - begin).count();
  }
  std::printf("%ld messages in %.2f s, %.0f a second\n", sent, elapsed,
              static_cast<double>(sent) / elapsed);
}
