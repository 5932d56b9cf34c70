// SPDX-License-Identifier: Apache-2.0
// Validation by integration.
#include "jounce/proof/proof.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "jounce/validate/integration_watch.hpp"

#include "python/src/bind.hpp"
#include "python/src/design.hpp"
#include "python/src/numpy/column.hpp"
#include "python/src/report.hpp"

namespace jounce::python {

using namespace py::literals;

namespace {

/// A proof with the texts that `jounce validate` prints.
struct NamedProof {
  NamedReport report;
  std::vector<DriveSample> samples;
  std::string text;
  std::string json;
};

/// Ends the work of a proof after Ctrl-C or an exception in the callback.
struct Stopped {};

NamedProof proven(const Input& input, const ProofOptions& options) {
  const Proof proof = prove(input, options);
  NamedProof named{
      {proof.report, input.labels}, {}, proof_answer(proof, input), proof_json(proof, input)};
  if (proof.drive && options.drive_samples > 0) named.samples = proof.drive->samples;
  return named;
}

NamedProof validate(const py::object& source, const std::filesystem::path& log, std::size_t samples,
                    const py::object& progress) {
  const Input input = input_of_argument(source);
  Watch watch(progress);
  const auto step = [&](double done) {
    if (!watch(done, "tolerances")) throw Stopped();
  };
  try {
    const py::gil_scoped_release release;
    const IntegrationWatch integration([&] {
      if (!watch(0, "integration")) throw Stopped();
    });
    return proven(input, {.log = log.string(), .drive_samples = samples, .progress = step});
  } catch (const Stopped&) {
  }
  watch.rethrow();
  throw InputError("progress", "False", "has stopped the validation");
}

py::dict signals(const NamedProof& proof) {
  py::dict columns;
  const auto add = [&](const char* name, double DriveSample::*member) {
    std::vector<double> values;
    for (const DriveSample& sample : proof.samples) values.push_back(sample.*member);
    columns[name] = taken(std::move(values));
  };
  if (proof.samples.empty()) return columns;
  add("time", &DriveSample::time);
  add("reference", &DriveSample::reference);
  add("motor", &DriveSample::motor);
  add("load", &DriveSample::load);
  add("torque", &DriveSample::torque);
  add("following_error", &DriveSample::following_error);
  add("velocity", &DriveSample::velocity);
  return columns;
}

}  // namespace

void bind_proof(py::module_& m) {
  py::class_<NamedProof>(
      m, "Proof", "Result of validate(). `print(proof)` prints it as `jounce validate` does.")
      .def_property_readonly(
          "ok", [](const NamedProof& p) { return p.report.report.ok(); },
          "True if no finding is broken.")
      .def_readonly("report", &NamedProof::report, "All findings, as a Report.")
      .def_property_readonly(
          "data", [](const NamedProof& p) { return from_json(p.json); },
          R"(All numbers as a dict: "witness", "drive", "tolerances", "follower", "executor".)")
      .def_property_readonly(
          "signals", signals,
          R"(Signals of the drive at equally spaced times, as a dict of arrays; empty without samples.

"time" (s), "reference", "motor", "load", "following_error" (u), "torque" (N m), "velocity" of the motor (rad/s).)")
      .def("__str__", [](const NamedProof& p) { return p.text; })
      .def("__repr__", [](const NamedProof& p) {
        return shown("Proof", {{"ok", p.report.report.ok() ? "True" : "False"},
                               {"findings", std::to_string(p.report.report.findings.size())}});
      });
  m.def(
      "validate", validate, "source"_a, py::kw_only(), "log"_a = "", "samples"_a = 0,
      "progress"_a = py::none(),
      R"(Proves a motion: integrates its curve and its table, and simulates the [drive] and the [follower] of
the spec.

source: a Design, a Table, or the path of a file. log: path of the tick log of an executor, to compare.
samples: number of samples of the drive's signals. progress: called with (done, step), where step is "integration"
(done is 0) or "tolerances"; if it returns False, InputError is raised. Ctrl-C ends the validation. The GIL is
released.)");
}

}  // namespace jounce::python
