// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "jounce/base/detail/printable.hpp"

#include "executor/src/record/record_fields.hpp"
#include "jounce_record/axis_t.hpp"
#include "jounce_record/check_t.hpp"
#include "jounce_record/compensation_t.hpp"
#include "jounce_record/cycle_t.hpp"
#include "jounce_record/gear_t.hpp"
#include "jounce_record/job_t.hpp"
#include "jounce_record/lost_t.hpp"
#include "jounce_record/master_t.hpp"
#include "jounce_record/output_t.hpp"
#include "jounce_record/path_switches_t.hpp"
#include "jounce_record/program_t.hpp"
#include "jounce_record/queue_t.hpp"
#include "jounce_record/references_t.hpp"
#include "jounce_record/registration_t.hpp"
#include "jounce_record/rows_t.hpp"
#include "jounce_record/sample_t.hpp"
#include "jounce_record/sight_t.hpp"
#include "jounce_record/table_t.hpp"
#include "jounce_record/triggers_t.hpp"

/// Converts every event of a record to its LCM type in executor/lcm, and back. ours() throws
/// InputError(field, value, rule) for a value out of range.
namespace jounce::record_wire {

using namespace jounce_record;
using namespace record_fields;

inline constexpr std::int16_t version = 8;           ///< version of the format, in every type
inline constexpr std::size_t knots_an_event = 200;   ///< greatest number of knots in an event
inline constexpr std::size_t values_an_event = 200;  ///< the same of values of a compensation

template <std::size_t N>
void put_text(const std::string& text, std::uint8_t (&bytes)[N]) {
  std::memset(bytes, 0, N);
  std::memcpy(bytes, text.data(), std::min(text.size(), N - 1));
}

template <std::size_t N>
std::string get_text(const std::uint8_t (&bytes)[N]) {
  return printable(std::string(bytes, std::find(bytes, bytes + N, 0)));
}

axis_t on_wire(const RecordedAxis& ours);
table_t on_wire(const RecordedTable& ours);
job_t on_wire(const RecordedJob& ours);
cycle_t on_wire(const RecordedCycle& ours);
lost_t on_wire(const RecordedLoss& ours);
gear_t on_wire(const RecordedGear& ours);
queue_t on_wire(const RecordedQueue& ours);
rows_t on_wire(const RecordedRows& ours);
master_t on_wire(const RecordedMaster& ours);
sight_t on_wire(const RecordedSight& ours);
output_t on_wire(const RecordedOutput& ours);
sample_t on_wire(const RecordedSample& ours);
program_t on_wire(const RecordedProgram& ours);
registration_t on_wire(const RecordedRegistration& ours);
triggers_t on_wire(const RecordedTriggers& ours);
check_t on_wire(const RecordedCheck& ours);
compensation_t on_wire(const RecordedCompensation& ours);
references_t on_wire(const RecordedReferences& ours);
path_switches_t on_wire(const RecordedPathSwitches& ours);

RecordedAxis ours(const axis_t& w);
RecordedTable ours(const table_t& w);
RecordedJob ours(const job_t& w);
RecordedCycle ours(const cycle_t& w);
RecordedLoss ours(const lost_t& w);
RecordedGear ours(const gear_t& w);
RecordedQueue ours(const queue_t& w);
RecordedRows ours(const rows_t& w);
RecordedMaster ours(const master_t& w);
RecordedSight ours(const sight_t& w);
RecordedOutput ours(const output_t& w);
RecordedSample ours(const sample_t& w);
RecordedProgram ours(const program_t& w);
RecordedRegistration ours(const registration_t& w);
RecordedTriggers ours(const triggers_t& w);
RecordedCheck ours(const check_t& w);
RecordedCompensation ours(const compensation_t& w);
RecordedReferences ours(const references_t& w);
RecordedPathSwitches ours(const path_switches_t& w);

}  // namespace jounce::record_wire
