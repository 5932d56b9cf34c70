// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "controllers/src/exchange/exchange_parts.hpp"

namespace jounce::controllers_detail {

/// A format with the functions that detect, read and write it.
struct FormatRow {
  CamFormat format;
  bool (*detects)(const std::string& text);
  /// All cams of the file, at least one; null if it cannot be read.
  std::vector<Exchanged> (*read)(const std::string& text, const Place& place);
  std::string (*write)(const TableFile& file);
  const char* unreadable = "";  ///< the reason, as a rule
};

/// One row for each vendor's source; formats.cpp lists them.
extern const FormatRow codesys_format;
extern const FormatRow twincat_format;
extern const FormatRow siemens_format;
extern const FormatRow siemens_points_format;
extern const FormatRow rockwell_format;
extern const FormatRow kollmorgen_format;
extern const FormatRow sew_format;
extern const FormatRow pairs_format;
extern const FormatRow xyva_format;

std::span<const FormatRow* const> format_rows();
const FormatRow& row_of(const CamFormat& format);

}  // namespace jounce::controllers_detail
