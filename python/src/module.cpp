// SPDX-License-Identifier: Apache-2.0
#include "python/src/bind.hpp"

namespace {

namespace py = pybind11;

/// Objects do not change, so copy.copy() and copy.deepcopy() return the same object. Two classes have a state.
void copy_by_reference(const py::module_& m) {
  for (const auto& [name, value] : py::dict(m.attr("__dict__"))) {
    if (!py::isinstance<py::type>(value) || value.is(m.attr("OnlineGenerator")) ||
        value.is(m.attr("Client")))
      continue;
    py::setattr(value, "__copy__",
                py::cpp_function([](const py::object& self) { return self; }, py::name("__copy__"),
                                 py::is_method(value)));
    py::setattr(value, "__deepcopy__",
                py::cpp_function([](const py::object& self, const py::object&) { return self; },
                                 py::name("__deepcopy__"), py::is_method(value)));
  }
}

}  // namespace

PYBIND11_MODULE(_jounce, m) {
  using namespace jounce::python;
  m.doc() = "Compiled part of the package jounce.";
  m.attr("__name__") = "jounce";  // the module that the classes name
  bind_errors(m);
  bind_reports(m);
  bind_curves(m);
  bind_moves(m);
  bind_sequences(m);
  bind_online(m);
  bind_cams(m);
  bind_gears(m);
  bind_tables(m);
  bind_designs(m);
  bind_paths(m);
  bind_optimum(m);
  bind_proof(m);
  bind_convert(m);
  bind_stream(m);
  copy_by_reference(m);
  m.attr("__version__") = JOUNCE_VERSION;
  m.attr("__name__") = "jounce._jounce";
}
