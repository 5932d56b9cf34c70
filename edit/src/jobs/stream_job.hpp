// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "jounce/machine/play_plan.hpp"
#include "jounce/stream/transport/keyed_link.hpp"

#include "edit/src/jobs/job.hpp"
#include "edit/src/json_reader.hpp"

namespace jounce::edit_detail {

/// A wish for a stream: its motion, its axis, and the master.
struct StreamRequest {
  std::size_t axis = 0;   ///< number of the axis of the spec, from 0
  std::string executor;   ///< name of the axis or group
  LinkOptions link;       ///< address of the executor
  PlayOptions play = {};  ///< master of a cam; a follow spec always has a live master
  std::optional<double> start_at =
      {};                 ///< live cam: it begins when the master passes this position
  bool relative = false;  ///< follow spec: positions count from the position of the axis
};

/// A table that is ready to be sent to an axis, with the facts that a person confirms.
struct StreamOffer {
  std::string text;          ///< text of the spec from which the table was made
  std::string confirmation;  ///< a random number, which permits to send this table once
  std::string executor;      ///< name of the axis or group
  LinkOptions link;          ///< address of the executor
  /// The table and its goal, the start of the motion. A follow spec has rows in two banks.
  std::variant<StreamPlan, BankPlan> plan;
  std::string hash = {};           ///< SHA-256 of the table; "": rows have none
  std::size_t knots = 0;           ///< number of knots or rows
  std::string begin = {};          ///< when the motion begins, in words
  double duration = 0;             ///< duration of the motion, in `time_unit`
  std::string time_unit = {};      ///< unit of `duration`; with a live master: unit of the master
  double start = 0;                ///< first position of the table, in `position_unit`
  std::string position_unit = {};  ///< unit of `start`
  std::string axis = {};  ///< state and position of the axis; "": the executor did not answer
};

/// Makes the table of an axis of a spec, or the path of all its axes. Asks the executor for its
/// state, and sends nothing else. Throws InputError for a text without a motion, for options that do
/// not fit the motion, and for a bad name or address.
StreamOffer stream_offer(const std::string& path, const std::string& text,
                         const StreamRequest& request);

/// Adds the facts of an offer to a JSON object.
void add_to(Json& object, const StreamOffer& offer);

/// Starts to send the table of an offer, and then its motion. If it is stopped before the motion has
/// begun, nothing moves.
std::unique_ptr<Job> stream_job(StreamOffer offer);

}  // namespace jounce::edit_detail
