// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "jounce/report/report_text.hpp"

namespace jounce::python {

/// A finding with the names and units of its report.
struct NamedFinding {
  Finding finding;
  std::string segment_name;
  std::string unit;
  std::string text;
};

/// A report with the names and units for its numbers.
struct NamedReport {
  Report report;
  Labels labels = {};

  [[nodiscard]] std::vector<NamedFinding> findings() const;
};

/// Returns a name with its numbers: "Cam(start=0, end=360)". For a number: six digits.
std::string shown(const std::string& name,
                  const std::vector<std::pair<std::string, std::string>>& members);
std::string shown(double value);

}  // namespace jounce::python
