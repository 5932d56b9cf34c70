// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jounce/design/input.hpp"
#include "jounce/report/diagnostic.hpp"

namespace jounce {

/// Examines the motions of one file: one report for each axis, in their order. May throw InputError, for example for a
/// limit that does not fit the axis. Called by several threads at once.
using Examine = std::function<std::vector<Report>(std::vector<Input>& axes)>;

/// Reads a file of any kind, examines its motions, and returns all findings and errors, each with its
/// place. It throws no InputError: bad input is a result.
///
///     const FileResult result = lint_file("cam.toml", [](std::vector<Input>& axes) {
///       std::vector<Report> reports;
///       for (const Input& axis : axes) reports.push_back(checked(axis));
///       return reports;
///     });
///
/// A kind without a motion is read as far as it can be without a machine: an axis with its drive, a machine with the
/// specs of its axes, a drive with the stability of its loop, a sweep with its spec, a path without commands, a key
/// file with its rights. `machine` is the path spec for a G-code program.
FileResult lint_file(const std::string& path, const Examine& examine,
                     const std::string& machine = "");

/// The same for many files, on all cores; the results are in the order of the files. `progress` receives the share
/// that is done.
std::vector<FileResult> lint_files(const std::vector<std::string>& paths, const Examine& examine,
                                   const std::string& machine = "",
                                   const std::function<void(double)>& progress = {});

/// True if the file is one of Jounce that has no motion to examine. False for a file that cannot be read.
bool is_without_motion(const std::string& path);

/// The path relative to the root of the git repository that it is in, as CI systems need it; outside a repository the
/// path relative to the current folder.
std::string repository_path(const std::string& path);

}  // namespace jounce
