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
  bind_sequences(m);
  bind_online(m);
  bind_cams(m);
  bind_tables(m);
  bind_designs(m);
  bind_optimum(m);
  bind_proof(m);
  bind_convert(m);
  bind_stream(m);
  m.attr("__version__") = JOUNCE_VERSION;
  m.attr("__name__") = "jounce._jounce";
}
