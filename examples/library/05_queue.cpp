// SPDX-License-Identifier: Apache-2.0
// Two moves after each other, in every buffer mode; then a move that is aborted on its way.
#include <cstdio>

#include "jounce/profiles/sequences/queue.hpp"

using namespace jounce;

int main() {
  // PMC600 manual 5.2.4, Fig. 5.21: pulses.
  const Dynamics slow{.velocity = 5000, .acceleration = 10000};
  const Dynamics fast{.velocity = 20000, .acceleration = 20000};
  const char* names[] = {"buffered", "blending low", "blending previous", "blending next",
                         "blending high"};
  for (int mode = 1; mode <= 5; ++mode) {
    const QueuedMotion m =
        queue({.commands = {{MoveAbsolute{10000}, slow},
                            {MoveAbsolute{50000}, fast, static_cast<BufferMode>(mode)}}});
    std::printf("%-17s %8.5f s; at 10000 after %.5f s with %5.0f\n", names[mode - 1],
                m.trajectory.end(), m.commands[0].end, m.commands[0].reached);
  }

  // Fig. 5.16: a farther target at a higher velocity, issued after 2 s.
  const QueuedMotion m =
      queue({.commands = {{MoveAbsolute{50000}, {.velocity = 10000, .acceleration = 100000}},
                          {.command = MoveAbsolute{100000},
                           .dynamics = {.velocity = 20000, .acceleration = 200000},
                           .mode = BufferMode::aborting,
                           .issued = 2}}});
  std::printf("aborted at %.0f; at %.0f after %.4f s\n", m.trajectory.at(2).position,
              m.end.position, m.trajectory.end());
}

// > buffered           5.50000 s; at 10000 after 2.50000 s with     0
// > blending low       5.03125 s; at 10000 after 2.25000 s with  5000
// > blending previous  5.03125 s; at 10000 after 2.25000 s with  5000
// > blending next      3.95711 s; at 10000 after 1.41421 s with 14142
// > blending high      3.95711 s; at 10000 after 1.41421 s with 14142
// > aborted at 19500; at 100000 after 6.0875 s
