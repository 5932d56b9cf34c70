// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "jounce/cam/fit/fit.hpp"
#include "jounce/design/input.hpp"

namespace jounce {

/// Options for reading and fitting measured points. A text is a number with or without a unit; "":
/// not given.
struct FitOptions {
  std::string tolerance =
      {};  ///< greatest distance from a point; "": the column `tolerance` of the file
  /// the cam repeats after this travel of the master; "": it does not repeat
  std::string period = {};
  std::string master_unit = {};    ///< unit of the master, if the file does not state it
  std::string position_unit = {};  ///< unit of the slave, if the file does not state it
  /// For a drawing: the keys of the table `drawing` of a segment (drawn_cam.hpp).
  std::string drawing = {};
};

/// A cam through the points of a file.
struct FittedCam {
  std::string source = {};  ///< name of the file
  Units units = {};         ///< units of the points
  std::size_t points = 0;   ///< number of points in the file
  double tolerance = 0;     ///< the greatest tolerance of a point, unit of the slave
  std::string text = {};    ///< the spec
  CamFit fit = {};          ///< the cam, as the text describes it
  /// Greatest distance of the cam from the motion between the points. This motion is the straight
  /// lines between the points or, for a table with velocities, the motion of the table. Exact, not
  /// sampled.
  SampleError between = {};
  bool curved = false;  ///< true: `between` is the distance from a table with velocities

  /// False if the cam leaves the tolerance of a point, or the tolerance between the points of a
  /// table with velocities.
  [[nodiscard]] bool ok() const {
    return fit.excess <= 0 && (!curved || between.position <= tolerance);
  }
};

/// Fits a cam to the points of a file: CSV with the columns `master`, `slave` and perhaps
/// `tolerance` (points.hpp), a drawing of the cam (drawn_cam.hpp), or a cam table of Jounce or of a
/// controller. A table with velocities is fitted at its knots and at places between them. The spec
/// of a plate contains [disc]. Throws InputError, with the place in the file, or with the name of a
/// member of FitOptions as its key.
FittedCam fitted_cam(const std::string& path, const FitOptions& options);
/// Like fitted_cam(), for the contents of a file with this name.
FittedCam fitted_cam(const std::string& text, const std::string& name, const FitOptions& options);

/// Returns the output of `jounce fit`: each segment with its distance from the points, and the
/// greatest distances.
std::string fit_text(const FittedCam& fitted);
/// Returns the contents of fit_text() as a JSON object; numbers have all their digits. `file` is
/// the name of the spec.
std::string fit_json(const FittedCam& fitted, const std::string& file);

}  // namespace jounce
