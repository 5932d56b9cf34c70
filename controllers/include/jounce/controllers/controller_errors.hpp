// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace jounce {

/// An error of a controller for a cam or a gear, and its equivalent in Jounce.
///
///     for (const ControllerError& error : controller_errors()) print(text(error));
///
/// `here` is "InputError KEY", "CouplingStatus NAME", "GearInPosStatus NAME", "SwitchStep lost" (of CamSwitches),
/// "Cause NAME" or "Refusal NAME" (of an executor), or "none": then `how` explains why it cannot occur.
/// docs/cam/errors.md is this table.
struct ControllerError {
  const char* controller;  ///< "PMC600" or "HMPL"
  unsigned code;
  const char* meaning;
  const char* here;
  const char* how;
};

/// PMC600 manual, appendix A-1: 600-602, 625-629, 675-679, 750-754, 775-777; HMPL manual 18.1.2: 0x1388-0x1397.
std::span<const ControllerError> controller_errors();

/// "627" or "0x1392".
std::string code_text(const ControllerError& error);

/// One row of the table in docs/cam/errors.md.
std::string row(const ControllerError& error);

}  // namespace jounce
