// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "controllers/src/exchange/exchange_parts.hpp"

namespace jounce::controllers_detail {

/// A format with the functions that detect, read and write it.
struct FormatRow {
  ExchangeFormat format;
  /// True if the text is in this format.
  bool (*detects)(const std::string& text);
  /// Returns all cams of the file, at least one. Null if Jounce cannot read the format.
  std::vector<Exchanged> (*read)(const std::string& text, const Place& place);
  /// Returns a table as text in this format.
  std::string (*write)(const TableFile& file);
  const char* unreadable = "";  ///< reason why the format cannot be read, as a rule
  /// True if texts of other formats look the same: then only the ending of a path selects it.
  bool by_ending_only = false;
};

/// The formats, one for each source of a vendor. Add a new format to the list in formats.cpp.
extern const FormatRow codesys_format;
extern const FormatRow plcopen_format;
extern const FormatRow twincat_format;
extern const FormatRow twincat_mc3_format;
extern const FormatRow siemens_format;
extern const FormatRow siemens_points_format;
extern const FormatRow rockwell_format;
extern const FormatRow kollmorgen_format;
extern const FormatRow sew_format;
extern const FormatRow ros_format;
extern const FormatRow xps_format;
extern const FormatRow zaber_format;
extern const FormatRow galil_format;
extern const FormatRow galil_pvt_format;
extern const FormatRow trio_format;
extern const FormatRow googol_pt_format;
extern const FormatRow googol_pt_st_format;
extern const FormatRow googol_follow_format;
extern const FormatRow googol_follow_st_format;
extern const FormatRow hmpl_format;
extern const FormatRow hmpl_gear_format;
extern const FormatRow pairs_format;
extern const FormatRow xyva_format;

/// Returns all formats, in the order in which they are tried.
std::span<const FormatRow* const> format_rows();
/// Returns the row of a format.
const FormatRow& row_of(const ExchangeFormat& format);

}  // namespace jounce::controllers_detail
