// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {

/// An error about a cam or a gear that a controller reports, and its equivalent in Jounce.
/// docs/cam/errors.md lists all of them.
///
///     for (const ControllerError& error : controller_errors()) use(row(error));
struct ControllerError {
  const char* controller;  ///< name of the controller: "PMC600" or "HMPL"
  unsigned code;           ///< error number in the manual of the controller
  const char* meaning;     ///< a few words: what happened
  /// The equivalent in Jounce: "InputError KEY", "CouplingStatus NAME", "GearInPosStatus NAME",
  /// "SwitchStep lost" (of CamSwitches), "Cause NAME" or "Refusal NAME" (of an executor), or
  /// "none".
  const char* here;
  const char* how;  ///< remark; for "none", the reason why the error cannot occur
};

/// Returns all errors: 600-602, 625-629, 675-679, 750-754, 775-777 of the PMC600 manual, appendix
/// A-1; 0x1388-0x1397 of the HMPL manual, 18.1.2.
std::span<const ControllerError> controller_errors();

/// Returns the error number as the manual writes it: "627" or "0x1392".
std::string code_text(const ControllerError& error);

/// Returns the row of the error in the table of docs/cam/errors.md.
std::string row(const ControllerError& error);

}  // namespace jounce
