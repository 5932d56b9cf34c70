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
/// Returns the names of the files that could not be written, from wire::Status::unwritten: "log,
/// black box".
std::string unwritten_files(std::uint8_t files);

}  // namespace jounce
