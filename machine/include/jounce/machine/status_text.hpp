// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "jounce/stream/message/message.hpp"

/// Statuses of an executor in one line of text or JSON, without a line end.
namespace jounce {

std::string status_text(const std::string& axis, const wire::Status& status);
std::string status_json(const std::string& axis, const wire::Status& status);

/// The state of a master that the axis follows.
std::string status_text(const std::string& axis, const wire::MasterStatus& master);
std::string status_json(const std::string& axis, const wire::MasterStatus& master);

/// A master in a few words: position, velocity and age of the measurement; or that it is lost.
std::string master_text(const wire::MasterStatus& master, bool ascii);

/// "log, black box": the files that could not be written, from wire::Status::unwritten.
std::string unwritten_files(std::uint8_t files);

}  // namespace jounce
