// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/message/refusals.hpp"

#include <array>

namespace jounce::wire {
namespace {

constexpr std::array entries{
    RefusalInfo{Refusal::none, "none", "Nothing is refused.", "Nothing."},
    RefusalInfo{Refusal::busy, "busy", "The axis belongs to another live session.",
                "Wait until that session ends."},
    RefusalInfo{Refusal::unknown_session, "unknown_session",
                "No header has opened this session: the executor has restarted.",
                "Send the header again."},
    RefusalInfo{Refusal::session_ended, "session_ended",
                "The session was released, has timed out, or an operator ended it.",
                "Begin another session."},
    RefusalInfo{Refusal::bad_header, "bad_header",
                "The header contradicts itself, or an earlier one of the same index.",
                "Correct the streamer."},
    RefusalInfo{Refusal::too_large, "too_large",
                "The table has more knots than the executor permits.",
                "Reduce the table: `tolerance` or `most` in [table]."},
    RefusalInfo{Refusal::out_of_memory, "out_of_memory",
                "The memory of the executor is full of tables in use.", "End other sessions."},
    RefusalInfo{Refusal::bad_chunk, "bad_chunk", "A chunk contradicts its header.",
                "Correct the streamer."},
    RefusalInfo{Refusal::hash_mismatch, "hash_mismatch",
                "All chunks have arrived, but they are not the table that was announced.",
                "Correct the streamer, or check its memory."},
    RefusalInfo{Refusal::bad_table, "bad_table",
                "The chunks are no table; the reason names knot and rule.",
                "Correct the streamer."},
    RefusalInfo{Refusal::table_missing, "table_missing",
                "The table to arm has not arrived completely.", "Send it first."},
    RefusalInfo{Refusal::wrong_axis, "wrong_axis",
                "The table is over time where one over the master is needed, or the reverse.",
                "Choose another mode."},
    RefusalInfo{
        Refusal::wrong_unit, "wrong_unit",
        "A table over time is not in s, or its master counts in another unit than x of the slave.",
        "Convert the table."},
    RefusalInfo{Refusal::not_armed, "not_armed", "A start came without an arm.",
                "Arm a table first."},
    RefusalInfo{Refusal::axis, "axis",
                "The axis rejected the command; the answer has its number and text.",
                "See the cause of the axis."},
    RefusalInfo{Refusal::stale_challenge, "stale_challenge",
                "The message does not carry the newest challenge of the executor.",
                "Take the one in the answer, and send the message again if it is still valid."},
    RefusalInfo{Refusal::bad_queue, "bad_queue",
                "The queue contradicts itself, or an earlier one of the same index.",
                "Correct the streamer."},
    RefusalInfo{Refusal::bad_rows, "bad_rows",
                "The rows contradict their queue, or the rows before them.",
                "Correct the streamer."},
    RefusalInfo{Refusal::bad_row, "bad_row",
                "A row exceeds a limit or leaves the path; the answer has its number and the rule.",
                "Correct the motion."},
    RefusalInfo{Refusal::queue_missing, "queue_missing", "The queue is not open.",
                "Open it first."},
    RefusalInfo{Refusal::prefill_missing, "prefill_missing", "The queue has too few rows to begin.",
                "Send more of them, then start."},
    RefusalInfo{Refusal::bad_order, "bad_order",
                "A value of the command is out of its range; the reason names it.",
                "Correct the value."},
};
static_assert(entries.size() == refusals);

}  // namespace

std::span<const RefusalInfo> all_refusals() {
  return entries;
}

const char* name(Refusal refusal) {
  return entries[static_cast<std::size_t>(refusal)].name;
}

}  // namespace jounce::wire
