#include "input.hpp"

#include <utility>

#include "jounce/io/file.hpp"

namespace jounce::cli {
namespace {

Input from_table(TableFile file, const std::string& path) {
  std::variant<Cam, Trajectory> curve =
      file.table.axis() == Axis::master
          ? std::variant<Cam, Trajectory>(file.table.curve<OverMaster>())
          : file.table.curve<OverTime>();
  Labels labels{file.units, file.table.axis() == Axis::master, {}};
  return {std::nullopt, std::move(curve), std::move(file), {}, {}, std::move(labels), path};
}

Input from_spec(Spec spec, const std::string& path) {
  Made made = make(spec);
  TableFile table{std::move(made.sampled.table),
                  spec.units,
                  {path == "-" ? "" : path, hex(spec.document.hash), made_by()}};
  Labels labels{spec.units, spec.is_cam(), std::move(made.segments)};
  Input input{std::nullopt,
              std::move(made.curve),
              std::move(table),
              made.sampled.error,
              spec.limits,
              std::move(labels),
              spec.name.empty() ? path : spec.name};
  input.spec = std::move(spec);
  return input;
}

}  // namespace

Input load(const std::string& path) {
  std::string text = read_file(path);
  const std::string name = path == "-" ? "standard input" : path;
  if (is_table(text)) return from_table(parse_table(text, name), name);
  return from_spec(parse_spec(std::move(text), name), path);
}

}  // namespace jounce::cli
