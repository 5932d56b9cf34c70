// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/refusals.hpp"

#include <array>

namespace jounce::wire {
namespace {

constexpr std::array entries{
    RefusalInfo{Refusal::none, "none", "Nothing is rejected.", "Nothing."},
    RefusalInfo{
        Refusal::busy, "busy", "Another program owns the axis: its session is open.",
        "Wait until that program ends, or stop the axis, which ends its session: `jounce stop "
        "NAME`."},
    RefusalInfo{Refusal::unknown_session, "unknown_session",
                "The executor does not have this session: it has restarted since.",
                "Send the header again."},
    RefusalInfo{Refusal::session_ended, "session_ended",
                "The session was released, has timed out, or an operator ended it.",
                "Send the command again: it opens a new session."},
    RefusalInfo{
        Refusal::bad_header, "bad_header",
        "The header of a table contradicts itself, or an earlier header with the same index.",
        "Correct the program that sends the table."},
    RefusalInfo{Refusal::too_large, "too_large",
                "The table has more knots than the executor permits.",
                "Reduce the table: `tolerance` or `most` in [table]."},
    RefusalInfo{Refusal::out_of_memory, "out_of_memory",
                "The memory of the executor is full: all its tables are in use.",
                "End other sessions, or reduce the table."},
    RefusalInfo{Refusal::bad_chunk, "bad_chunk",
                "A part of the table (chunk) contradicts its header.",
                "Correct the program that sends the table."},
    RefusalInfo{Refusal::hash_mismatch, "hash_mismatch",
                "All parts of the table (chunks) have arrived, but their hash differs from that of "
                "the header.",
                "Correct the program that sends the table, or check the memory of its computer."},
    RefusalInfo{Refusal::bad_table, "bad_table",
                "The parts that have arrived are not a valid table; the message names the knot and "
                "the rule.",
                "Correct the program that sends the table."},
    RefusalInfo{Refusal::table_missing, "table_missing",
                "The table that the command arms has not arrived completely.",
                "Send the whole table first."},
    RefusalInfo{Refusal::wrong_axis, "wrong_axis",
                "The table is over time, but must be over the master; or the reverse.",
                "Send the other kind of table, or arm in another mode."},
    RefusalInfo{
        Refusal::wrong_unit, "wrong_unit",
        "The time of a table is not in s, or the unit of the master differs from that of the cam.",
        "Convert the table: `jounce convert`."},
    RefusalInfo{Refusal::not_armed, "not_armed", "The start came before a table was armed.",
                "Arm a table first."},
    RefusalInfo{
        Refusal::axis, "axis",
        "The axis rejected the command; the answer has the number and the text of the cause.",
        "Look up the cause: `jounce explain NUMBER`."},
    RefusalInfo{
        Refusal::stale_challenge, "stale_challenge",
        "The message does not contain the newest challenge (random number) of the executor.",
        "Take the challenge from the answer. If the command is still wanted, send the message "
        "again with it."},
    RefusalInfo{
        Refusal::bad_queue, "bad_queue",
        "The header of a queue contradicts itself, or an earlier header with the same index.",
        "Correct the program that sends the table."},
    RefusalInfo{Refusal::bad_rows, "bad_rows",
                "The rows contradict their queue, or the rows before them.",
                "Correct the program that sends the table."},
    RefusalInfo{Refusal::bad_row, "bad_row",
                "A row exceeds a limit or leaves the path; the answer has the number of the row "
                "and the rule.",
                "Correct the motion."},
    RefusalInfo{Refusal::queue_missing, "queue_missing", "The queue is not open.",
                "Open the queue first."},
    RefusalInfo{Refusal::prefill_missing, "prefill_missing", "The queue has too few rows to begin.",
                "Send more rows, then start."},
    RefusalInfo{Refusal::bad_order, "bad_order",
                "A value of the command is out of its range; the message names the value.",
                "Correct this value."},
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
