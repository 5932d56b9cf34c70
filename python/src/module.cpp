// SPDX-License-Identifier: Apache-2.0
#include "python/src/bind.hpp"

PYBIND11_MODULE(_jounce, m) {
  using namespace jounce::python;
  m.doc() = "Compiled part of the package jounce.";
  m.attr("__name__") = "jounce";  // the module that the classes name
  bind_errors(m);
  bind_reports(m);
  bind_curves(m);
  bind_moves(m);
  m.attr("__version__") = JOUNCE_VERSION;
  m.attr("__name__") = "jounce._jounce";
}
