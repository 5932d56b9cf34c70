#include "reference.hpp"

#include "jounce/io/units.hpp"

namespace jounce::cli {
namespace {

double seconds(const Input& input) {
  return conversion(input.table.units.x, "s");
}

Trajectory master_of(const Input& input) {
  if (!input.spec)
    throw InputError(
        "master", "",
        "a cam table does not say how its master runs: give the spec, or a master table")
        .at(input.name);
  return make_master(*input.spec);
}

}  // namespace

Reference exact_reference(const Input& input) {
  if (const auto* cam = std::get_if<Cam>(&input.curve)) return Followed(*cam, master_of(input));
  return scaled(std::get<Trajectory>(input.curve), 1, seconds(input));
}

Reference table_reference(const Input& input) {
  if (std::holds_alternative<Cam>(input.curve))
    return Followed(input.table.table.curve<OverMaster>(), master_of(input));
  return stretched(input.table.table, seconds(input)).curve<OverTime>();
}

Tables executor_tables(const Input& input) {
  const Units& units = input.table.units;
  if (std::holds_alternative<Cam>(input.curve)) {
    // A trapezoid and a straight line are what a cubic table holds exactly, knot for knot.
    const Trajectory motion = master_of(input);
    const std::vector<double> knots(motion.breaks().begin(), motion.breaks().end());
    Sampled master = sample(motion, Rule::cubic_hermite, knots);
    return {input.table,
            TableFile{std::move(master.table), {"s", units.x}, input.table.provenance}};
  }
  return {TableFile{stretched(input.table.table, seconds(input)),
                    {"s", units.position},
                    input.table.provenance},
          std::nullopt};
}

SignalView view(const Reference& reference) {
  return std::visit([](const auto& signal) { return SignalView(signal); }, reference);
}

double duration(const Reference& reference) {
  return std::visit([](const auto& signal) { return signal.end() - signal.start(); }, reference);
}

Motion at(const Reference& reference, double t) {
  return std::visit([&](const auto& signal) { return signal.at(signal.start() + t); }, reference);
}

}  // namespace jounce::cli
