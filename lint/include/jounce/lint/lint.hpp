// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/detail/diagnostic.hpp"
#include "jounce/spec/machine_spec.hpp"

namespace jounce {

/// Examines the motions of one file. Returns one report for each axis, in the order of `axes`. May
/// throw InputError, for example for a limit that the axis cannot have. Several threads call the
/// function at the same time.
using Examine = std::function<std::vector<Report>(std::vector<Input>& axes)>;

/// Functions that examine the spec of an axis or of a machine, and throw InputError for a spec that
/// an executor would reject. Both functions may be empty.
struct ExamineMachine {
  std::function<void(const Spec& axis)> axis = {};
  std::function<void(const MachineSpec& machine)> machine = {};
};

/// Reads a file of any kind, examines its motions, and returns all findings and errors, each with
/// its place in the file. Does not throw InputError: an error in the input is part of the result.
///
///     const FileResult result = lint_file("cam.toml", [](std::vector<Input>& axes) {
///       std::vector<Report> reports;
///       for (const Input& axis : axes) reports.push_back(check_all(axis));
///       return reports;
///     });
///
/// Some files have no motion. For these, the function checks: for an axis, its drive, and
/// executor.axis; for a machine, the specs of its axes, and executor.machine; for a drive, the
/// stability of its loop; for a sweep, its spec; for a key file, its access rights. A path without
/// commands is only read. For a G-code program, `machine` is the file of
/// a spec of kind "path", with the axes and limits of its machine.
FileResult lint_file(const std::string& path, const Examine& examine,
                     const std::string& machine = "", const ExamineMachine& executor = {});

/// Like lint_file(), for a text that is not, or not yet, in the file `path`. Other files that the
/// text names are read from the disk.
FileResult lint_text(const std::string& path, std::string text, const Examine& examine);

/// Examines many files, on all cores. The results have the order of the files. `progress` receives
/// the share that is done, 0 to 1.
std::vector<FileResult> lint_files(const std::vector<std::string>& paths, const Examine& examine,
                                   const std::string& machine = "",
                                   const std::function<void(double)>& progress = {},
                                   const ExamineMachine& executor = {});

/// True for a file of Jounce that has no motion to examine. False for a file that cannot be read.
bool is_without_motion(const std::string& path);

/// Returns the path relative to the root of the git repository that contains the file, as CI
/// systems need it. Outside a repository, returns the path relative to the current folder.
std::string repository_path(const std::string& path);

}  // namespace jounce
