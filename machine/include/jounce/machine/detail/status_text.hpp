// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"

/// Returns the status of an axis as one line of text, without a line end.
namespace jounce {

std::string status_text(const std::string& axis, const wire::Status& status);
/// Returns the status of an axis as JSON in one line.
std::string status_json(const std::string& axis, const wire::Status& status);

/// Returns the state of a master that the axis follows, in one line of text.
std::string status_text(const std::string& axis, const wire::MasterStatus& master);
/// Returns the state of a master as JSON in one line.
std::string status_json(const std::string& axis, const wire::MasterStatus& master);

/// Returns the place of a group on its path, in one line of text.
std::string status_text(const std::string& group, const wire::GroupStatus& status,
                        const std::string& unit);
/// Returns the place of a group on its path as JSON in one line.
std::string status_json(const std::string& group, const wire::GroupStatus& status);
/// Returns the place of a group in a few words: "x 10 mm c 30 deg; path 12.5 mm of 400 mm, line
/// 7", with "frame" before it if the coordinates count in a frame. `unit`: unit of its path.
std::string place_text(const wire::GroupStatus& group, const std::string& unit);
/// Returns what remains of the path of a group in a few words: "3.25 s (estimate), 4 commands,
/// look-ahead 380 mm".
std::string remaining_text(const wire::GroupStatus& group, const std::string& unit);

/// Returns an event of an axis, in one line of text: "label  event 17  tick 1203 - 412 us  probe 1
/// rising at 123.4567".
std::string status_text(const std::string& axis, const wire::Event& event);
/// Returns an event as JSON in one line.
std::string status_json(const std::string& axis, const wire::Event& event);
/// Returns an event in a few words: "probe 1 rising at 123.4567".
std::string event_text(const wire::Event& event);

/// Returns the position, the velocity and the age of the measurement of a master in a few words.
/// For a lost master, returns that it is lost. `ascii` selects ASCII characters only.
std::string master_text(const wire::MasterStatus& master, bool ascii);

/// Returns the state of the gear pair of an axis with its live master: "in gear, ratio -0.5".
std::string gear_text(const wire::Status& status);
/// Returns what an accepted start waits for: "start waits until its master passes 340 mm"; "" if no
/// start waits.
std::string waits_text(const wire::Status& status);
/// Returns the names of the files that could not be written, from wire::Status::unwritten: "log,
/// black box".
std::string unwritten_files(std::uint8_t files);

}  // namespace jounce
