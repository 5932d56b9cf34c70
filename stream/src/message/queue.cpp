// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/queue.hpp"

#include <cmath>
#include <tuple>

namespace jounce::wire {

bool operator==(const Queue& a, const Queue& b) {
  const auto fields = [](const Queue& q) {
    return std::tie(q.queue, q.axis, q.units.x, q.units.position, q.mode, q.capacity, q.loops,
                    q.event, q.event_position, q.event_direction, q.prefill, q.relative, q.origin,
                    q.lowest, q.highest, q.direction);
  };
  return fields(a) == fields(b);
}

std::int8_t variable_number(const Queue& queue) {
  if (queue.axis == Domain::time) return 0;
  return queue.direction == 0 ? 1 : queue.direction > 0 ? 2 : 3;
}

bool set_variable(std::int64_t number, Queue& queue) {
  queue.axis = number == 0 ? Domain::time : Domain::master;
  queue.direction = static_cast<std::int8_t>(number == 2 ? 1 : number == 3 ? -1 : 0);
  return number >= 0 && number <= 3;
}

std::uint32_t room(const Queue& queue) {
  return queue.mode == QueueMode::dynamic ? 2 * queue.capacity : queue.capacity;
}

std::string contradiction(const Queue& queue) {
  if (queue.queue < first_queue || queue.queue > last_queue) return "a queue's index is 64 to 127";
  if (queue.capacity < 2 || queue.capacity > 1U << 30U) return "a bank holds 2 to 2^30 rows";
  if (queue.prefill < 1 || queue.prefill > room(queue))
    return "the prefill must be 1 to the " + std::to_string(room(queue)) + " rows of the queue";
  if (queue.mode == QueueMode::dynamic && queue.loops != 1)
    return "a dynamic queue is played once: loops must be 1";
  if (queue.direction < -1 || queue.direction > 1) return "the direction must be -1, 0 or 1";
  if (queue.direction != 0 && queue.axis == Domain::time)
    return "a direction needs a queue over master position";
  const bool pass = queue.event == QueueEvent::pass;
  if (pass && queue.axis == Domain::time)
    return "the event pass needs a queue over master position";
  if (pass && !std::isfinite(queue.event_position)) return "the event's position must be finite";
  if (pass && queue.event_direction != 1 && queue.event_direction != -1)
    return "the event's direction must be 1 or -1";
  if (!pass && (queue.event_position != 0 || queue.event_direction != 0))
    return "only the event pass takes an event position and direction";
  if (!std::isfinite(queue.origin)) return "the origin must be finite";
  if (queue.relative && queue.origin != 0) return "the origin of a relative queue must be 0";
  if (!(queue.lowest <= 0 && queue.highest >= 0))
    return "the range counts from the origin: lowest must be 0 or less, highest 0 or more";
  return "";
}

}  // namespace jounce::wire
