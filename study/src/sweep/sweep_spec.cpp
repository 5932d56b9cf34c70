// SPDX-License-Identifier: Apache-2.0
#include "jounce/study/detail/sweep_spec.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <utility>

#include "jounce/base/detail/printable.hpp"
#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/io/table_file.hpp"
#include "jounce/spec/detail/share.hpp"
#include "jounce/spec/detail/toml_reader.hpp"

#include "study/src/sweep/counter_random.hpp"

namespace jounce {
namespace {

using spec_detail::TomlReader;

/// A number without a unit in the spec can be given only without a unit: this reader cannot determine its unit.
template <class Read>
auto read_in(const std::string& unit, const Read& read) -> decltype(read("")) {
  if (!unit.empty()) return read(unit);
  try {
    return read("1");
  } catch (const InputError& error) {
    if (!error.value().starts_with('"')) throw;
    throw InputError(error.key(), error.value(), "must be a number without a unit, as in the spec")
        .at(error.document(), error.line(), error.column());
  }
}

/// Rejects a table without this key, which no other key replaces. Also reports the keys that are not
/// in the format, first those of other programs that have this meaning.
[[noreturn]] void reject_missing(TomlReader& table, const char* key, const std::string& rule,
                                 std::initializer_list<const char*> others) {
  const std::string meant = std::string("is not a key here: did you mean ") + key + "?";
  for (const char* other : others) table.refuse_here(other, meant);
  table.finish();
  table.fail(key, "", rule);
}

Values read_grid(TomlReader& table, const std::string& unit) {
  const double from = read_in(unit, [&](const auto& u) { return table.number("from", u); });
  const double to = read_in(unit, [&](const auto& u) { return table.number("to", u); });
  if (from == to)
    table.fail("to", number(to), "must differ from from: give one value as values = [NUMBER]");
  const auto count = table.optional_count("count");
  if (!count)
    reject_missing(table, "count", "is missing: give the number of values, both ends included",
                   {"steps", "step", "points", "samples", "number", "n"});
  if (*count < 2) table.fail("count", std::to_string(*count), "must be at least 2");
  if (*count > SweepSpec::most_cases)
    table.fail("count", std::to_string(*count),
               "makes more than 10000000 cases: give a lower count");
  Values values;
  for (std::size_t i = 0; i < *count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(*count - 1);
    values.all.push_back(from * (1 - share) + to * share);
  }
  return values;
}

Values read_list(TomlReader& table, const std::string& unit) {
  Values values{read_in(unit, [&](const auto& u) { return table.number_list("values", u); })};
  if (values.all.empty()) table.fail("values", "", "is empty: give at least one value");
  return values;
}

UniformSpread read_uniform(TomlReader uniform, const std::string& unit) {
  UniformSpread spread;
  spread.from = read_in(unit, [&](const auto& u) { return uniform.number("from", u); });
  spread.to = read_in(unit, [&](const auto& u) { return uniform.number("to", u); });
  if (!(spread.from < spread.to))
    uniform.fail("to", number(spread.to), "must be greater than from, " + number(spread.from));
  uniform.finish();
  return spread;
}

NormalSpread read_normal(TomlReader normal, const std::string& unit, double given) {
  NormalSpread spread;
  spread.mean = read_in(unit, [&](const auto& u) {
                  return normal.optional_number("mean", u);
                }).value_or(given);
  spread.sigma = read_in(unit, [&](const auto& u) { return normal.number("sigma", u); });
  if (!(spread.sigma > 0)) normal.fail("sigma", number(spread.sigma), "must be greater than 0");
  normal.finish();
  return spread;
}

/// "5 %" or 0.05, of the number that the spec gives.
UniformSpread read_tolerance(TomlReader& table, double given) {
  const double share = *optional_share(table, "tolerance");
  if (!(share > 0))
    table.fail("tolerance", number(share),
               "must be a share such as \"5 %\" or 0.05, greater than 0");
  if (given == 0)
    table.fail("tolerance", number(share),
               "is relative to the number in the spec, which is 0: use uniform = { from, to }");
  const double width = share * std::abs(given);
  return {given - width, given + width};
}

SweepParameter read_parameter(TomlReader& table, const SpecNumbers& base) {
  SweepParameter p;
  p.key = table.text("key", "KEY");
  double given = 0;
  try {
    given = base.value(p.key);
    p.unit = base.unit(p.key);
  } catch (const InputError& error) {
    const std::string here = "this file";
    std::string rule = error.rule();
    if (const auto at = rule.find(here); at != std::string::npos)
      rule.replace(at, here.size(), base.document().name);
    else
      rule += " in " + base.document().name;
    table.fail("key", '"' + p.key + '"', rule);
  }
  constexpr std::array ways{"values", "from", "tolerance", "uniform", "normal"};
  std::vector<const char*> named;
  for (const char* way : ways)
    if (table.has(way)) named.push_back(way);
  if (named.size() != 1)
    table.fail("key", '"' + p.key + '"',
               "needs exactly one of the keys values, from (with to and count), tolerance, "
               "uniform, normal");
  const std::string way = named.front();
  if (way == "values") p.how = read_list(table, p.unit);
  if (way == "from") p.how = read_grid(table, p.unit);
  if (way == "tolerance") p.how = read_tolerance(table, given);
  if (way == "uniform") p.how = read_uniform(table.table("uniform"), p.unit);
  if (way == "normal") p.how = read_normal(table.table("normal"), p.unit, given);
  table.finish();
  return p;
}

void read_parameters(TomlReader& top, SweepSpec& spec) {
  top.for_each("parameter", [&](TomlReader& table) {
    SweepParameter p = read_parameter(table, spec.base);
    for (const SweepParameter& other : spec.parameters)
      if (other.key == p.key) table.fail("key", '"' + p.key + '"', "is given twice");
    spec.parameters.push_back(std::move(p));
  });
  if (spec.parameters.empty())
    top.fail("parameter", "",
             "is missing: add [[parameter]] with key and values for each number to vary");
}

void read_design(TomlReader& table, SweepSpec& spec) {
  const std::array<std::string, 3> names{"random", "latin_hypercube", "sobol"};
  if (!table.has("design")) return;
  const auto design = static_cast<Design>(table.choice("design", names));
  std::vector<std::string> random;
  for (const SweepParameter& p : spec.parameters)
    if (p.random()) random.push_back(p.key);
  if (spec.samples > SweepSpec::most_cases)
    table.fail("samples", std::to_string(spec.samples), "are too many: at most 10000000");
  try {
    spec.design = SampleDesign(design, spec.seed, std::move(random), spec.samples);
  } catch (const InputError& error) {
    table.fail("design", error.value(), error.rule());
  }
}

void read_monte_carlo(TomlReader& top, SweepSpec& spec) {
  auto table = top.optional_table("monte_carlo");
  if (!table && spec.random())
    top.fail("monte_carlo", "",
             "is missing: a parameter is random; add [monte_carlo] with samples = 1000");
  if (!table) return;
  if (!spec.random())
    top.fail("monte_carlo", "", "needs a parameter with tolerance, uniform or normal");
  const auto samples = table->optional_count("samples");
  if (!samples) {
    table->may_have("seed");
    table->may_have("design");
    reject_missing(*table, "samples", "is missing: add samples = NUMBER, the number of cases",
                   {"count", "cases", "runs", "number", "n"});
  }
  spec.samples = *samples;
  if (const auto seed = table->optional_whole("seed"))
    spec.seed = static_cast<std::uint64_t>(*seed);
  read_design(*table, spec);
  table->finish();
}

bool read_optima(TomlReader& top, const SpecNumbers& base) {
  if (!top.optional_flag("optima").value_or(false)) return false;
  if (!base.spec({}).parameters)
    top.fail("optima", "true",
             "needs a spec with [[optimize.parameter]] (" + base.document().name + ")");
  return true;
}

void require_few(const TomlReader& top, const SweepSpec& spec) {
  double cases = static_cast<double>(spec.samples);
  for (const SweepParameter& p : spec.parameters)
    if (const auto* values = std::get_if<Values>(&p.how))
      cases *= static_cast<double>(values->all.size());
  if (cases > static_cast<double>(SweepSpec::most_cases))
    throw InputError("parameter", number(cases), "cases are too many: at most 10000000")
        .at(top.document().name);
}

/// The figures that are named, and those of the objectives and limits; "margin" always, as it makes
/// the report whole.
std::vector<std::string> wanted(const std::vector<std::string>& figures, const SweepSpec& spec,
                                const std::vector<std::string>& limited) {
  std::vector<std::string> all = figures;
  for (const SweepObjective& o : spec.objectives) all.push_back(o.figure);
  all.insert(all.end(), limited.begin(), limited.end());
  all.emplace_back("margin");
  std::vector<std::string> once;
  for (const std::string& name : all)
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  return once;
}

Assessment assess_given(TomlReader& top, const SweepSpec& spec,
                        const std::vector<std::string>& names) {
  try {
    const Spec given = spec.base.spec({});
    top.record_files(given.document.files);
    return assess(given, names);
  } catch (const InputError& error) {
    if (error.key() != "figure") throw;
    for (const char* key : {"figures", "minimize", "maximize"}) {
      const auto texts = top.texts(key);
      if (std::any_of(texts.begin(), texts.end(),
                      [&](const std::string& name) { return '"' + name + '"' == error.value(); }))
        top.fail(key, error.value(), error.rule());
    }
    throw InputError("limits", error.value(), error.rule()).at(top.document().name);
  }
}

/// The numbers that each case chooses, as columns behind the figures.
void add_chosen(SweepSpec& spec) {
  const Spec given = spec.base.spec({});
  for (const SpecParameter& p : given.parameters->parameters) {
    spec.given.push_back({p.key, spec.base.value(p.key), spec.base.unit(p.key), {}});
    ++spec.chosen;
  }
}

void read_figures(TomlReader& top, SweepSpec& spec) {
  const std::vector<std::string> figures = top.texts("figures");
  for (const char* key : {"minimize", "maximize"})
    for (const std::string& name : top.texts(key)) {
      if (std::any_of(spec.objectives.begin(), spec.objectives.end(),
                      [&](const auto& other) { return other.figure == name; }))
        top.fail(key, '"' + name + '"', "is an objective already: name each figure once");
      spec.objectives.push_back({name, key == std::string_view("maximize")});
    }
  auto limits = top.optional_table("limits");
  const std::vector<std::string> limited = limits ? limits->keys() : std::vector<std::string>{};
  Assessment given = assess_given(
      top, spec, top.has("figures") ? wanted(figures, spec, limited) : std::vector<std::string>{});
  if (!top.has("figures") && !(spec.objectives.empty() && limited.empty()))
    (void)assess_given(top, spec, wanted({}, spec, limited));
  spec.given = std::move(given.figures);
  if (spec.optima) add_chosen(spec);
  spec.given_ok = given.report.ok();
  for (const std::string& name : limited) {
    const auto figure = std::find_if(spec.given.begin(), spec.given.end(),
                                     [&](const KeyFigure& f) { return f.name == name; });
    const double most = limits->number(name.c_str(), figure->unit.empty() ? "1" : figure->unit);
    spec.limits.push_back({name, most});
    spec.given_ok = spec.given_ok && figure->value <= most;
  }
}

}  // namespace

bool SweepSpec::random() const {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](const SweepParameter& p) { return p.random(); });
}

std::size_t SweepSpec::cases() const {
  std::size_t all = samples;
  for (const SweepParameter& p : parameters)
    if (const auto* values = std::get_if<Values>(&p.how)) all *= values->all.size();
  return all;
}

std::vector<SpecNumbers::Change> SweepSpec::numbers(std::size_t number) const {
  const std::size_t sample = number % samples;
  std::size_t rest = number / samples;
  std::vector<SpecNumbers::Change> all(parameters.size());
  auto random = static_cast<std::size_t>(std::count_if(
      parameters.begin(), parameters.end(), [](const SweepParameter& p) { return p.random(); }));
  for (std::size_t i = parameters.size(); i-- > 0;) {
    const SweepParameter& p = parameters[i];
    if (const auto* values = std::get_if<Values>(&p.how)) {
      all[i] = {p.key, values->all[rest % values->all.size()]};
      rest /= values->all.size();
    } else {
      all[i] = {p.key, drawn(p, --random, sample)};
    }
  }
  return all;
}

double SweepSpec::drawn(const SweepParameter& p, std::size_t which, std::size_t sample) const {
  const Draw draw{seed, stream_of(p.key), sample};
  if (const auto* spread = std::get_if<UniformSpread>(&p.how)) {
    const double u = independent() ? uniform(draw) : design.at(which, sample);
    return spread->from + (spread->to - spread->from) * u;
  }
  const auto& bell = std::get<NormalSpread>(p.how);
  const double g = independent() ? normal(draw) : normal_quantile(design.at(which, sample));
  return bell.mean + bell.sigma * g;
}

Sha256 SweepSpec::identity() const {
  std::string all = made_by() + '\0' + document.text + '\0' + base.document().text + '\0';
  for (const KeyFigure& f : given) all += f.name + '=' + jounce::number(f.value) + '\0';
  return sha256(all);
}

SweepSpec read_sweep(const std::string& path) {
  return parse_sweep(read_file(path), path);
}

namespace {

SweepSpec read_body(TomlReader& top, const std::filesystem::path& folder) {
  spec_detail::require_version(top);
  if (const std::string kind = top.text("kind", "sweep"); kind != "sweep")
    top.fail_all("kind", '"' + kind + '"',
                 "must be \"sweep\": write a second spec with kind = \"sweep\", a [[parameter]], "
                 "and spec = \"" +
                     std::filesystem::path(top.document().name).filename().string() +
                     "\" (see jounce sweep --help)");
  std::string name = top.optional_text("name").value_or("");
  if (!top.has("spec")) {  // a key in its place is an error, too
    static_cast<void>(top.text("spec", "FILE.toml"));
    for (const char* key :
         {"optima", "parameter", "monte_carlo", "figures", "minimize", "maximize", "limits"})
      top.may_have(key);
    top.finish();
    throw spec_detail::PartEnded{};
  }
  const std::string base = (folder / top.text("spec", "FILE.toml")).string();
  SweepSpec spec{
      {},
      std::move(name),
      SpecNumbers({base, top.file_of("spec", base, [&] { return read_file(base); }), {}, {}}),
      {},
      1,
      1,
      {},
      false,
      0,
      {},
      false,
      {},
      {}};
  spec.optima = read_optima(top, spec.base);
  read_parameters(top, spec);
  top.attempt([&] { read_monte_carlo(top, spec); });
  require_few(top, spec);
  read_figures(top, spec);
  top.finish();
  return spec;
}

}  // namespace

SweepSpec parse_sweep(std::string text, const std::string& path) {
  Document document{path == "-" ? "standard input" : path, std::move(text), {}, {}};
  document.hash = sha256(document.text);
  const toml::table root = spec_detail::parse_toml(document);
  const auto folder = std::filesystem::path(path == "-" ? "." : path).parent_path();
  auto spec = spec_detail::read_document(root, [&](spec_detail::ErrorList& errors) {
    std::optional<SweepSpec> read;
    Document read_from = document;
    TomlReader top(root, "", read_from, &errors);
    top.attempt([&] { read = read_body(top, folder); });
    if (read) read->document = std::move(read_from);
    return read;
  });
  return *std::move(spec);
}

}  // namespace jounce
