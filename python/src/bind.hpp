// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

/// The Python module: each function adds one topic to the module `jounce._jounce`. The package in `python/jounce`
/// exports all of it. A topic that uses a class of another topic is bound after it.
namespace jounce::python {

namespace py = pybind11;

void bind_errors(py::module_& m);     ///< exceptions of Jounce as exceptions of Python
void bind_reports(py::module_& m);    ///< limits, findings, reports
void bind_curves(py::module_& m);     ///< trajectories and cams: evaluation, algebra, exact extrema
void bind_moves(py::module_& m);      ///< bounds, moves, batches of moves
void bind_sequences(py::module_& m);  ///< several axes, via points, queues
void bind_online(py::module_& m);     ///< setpoints in each cycle
void bind_cams(py::module_& m);       ///< cams from segments with laws
void bind_gears(py::module_& m);      ///< gears as cams
void bind_tables(py::module_& m);     ///< tables and their files
void bind_designs(py::module_& m);    ///< specs and table files with their curves and findings
void bind_paths(py::module_& m);      ///< paths of several axes
void bind_optimum(py::module_& m);    ///< optimization of specs
void bind_proof(py::module_& m);      ///< validation by integration
void bind_convert(py::module_& m);    ///< formats of controllers
void bind_stream(py::module_& m);     ///< client of an executor

}  // namespace jounce::python
