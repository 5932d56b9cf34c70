// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/path/program_numbers.hpp"
#include "jounce/spec/machine_spec.hpp"
#include "jounce/spec/spec.hpp"

#include "spec/src/toml/parts.hpp"

namespace jounce {
namespace {

using spec_detail::TomlReader;

const std::vector<std::string> sides{"setpoint", "actual"};

MachineSpec::Axis read_one(TomlReader& reader, const std::filesystem::path& folder) {
  MachineSpec::Axis axis{.spec = reader.text("spec", "FILE.toml"), .key = reader.path("spec")};
  axis.key.erase(axis.key.rfind('.'));
  if (const std::filesystem::path given(axis.spec); given.is_relative())
    axis.spec = (folder / given).string();
  axis.follow = spec_detail::read_whom(reader);
  reader.finish();
  return axis;
}

/// A file that a spec in `folder` names; "": none.
std::string beside(const std::filesystem::path& folder, const std::string& file) {
  const std::filesystem::path given(file);
  return !file.empty() && given.is_relative() ? (folder / given).string() : file;
}

/// Reads m_words = "all", or the numbers of the M words.
void read_m_words(TomlReader& reader, MachineSpec::Group& group) {
  reader.may_have("m_words");
  if (!reader.has("m_words")) return;
  if (reader.is_text("m_words")) {
    static const std::vector<std::string> words{"all"};
    (void)reader.choice("m_words", words);
    group.m_words.reset();
    return;
  }
  group.m_words->clear();
  for (const double number : reader.number_list("m_words", "1")) {
    if (!(number >= 0 && number <= ProgramWord::most_m_word && number == std::floor(number)))
      reader.fail("m_words", jounce::number(number),
                  "must be \"all\", or a list of M words, such as [0, 6]");
    group.m_words->push_back(static_cast<std::int32_t>(number));
  }
}

MachineSpec::Group read_group(TomlReader& reader, const std::filesystem::path& folder) {
  MachineSpec::Group group{.name = reader.text("name"), .key = reader.path("name")};
  group.key.erase(group.key.rfind('.'));
  group.axes = reader.texts("axes");
  if (group.axes.empty())
    reader.fail("axes", "", "is missing: add the names of its axes, such as axes = [\"x\", \"y\"]");
  group.followers = reader.texts("followers");
  group.program = beside(folder, reader.optional_text("program").value_or(""));
  group.kinematics = beside(folder, reader.optional_text("kinematics").value_or(""));
  group.tolerance = reader.optional_quantity("tolerance");
  read_m_words(reader, group);
  group.m_word_timeout = reader.optional_positive("m_word_timeout", "s").value_or(0);
  reader.finish();
  return group;
}

/// The communication thread runs every 2 ms: a shorter watchdog time would expire without a fault.
std::optional<double> read_watchdog(TomlReader& top) {
  const auto watchdog = top.optional_number("watchdog", "s");
  if (watchdog && *watchdog != 0 && !(*watchdog >= 0.01 && *watchdog <= 3600))
    top.fail("watchdog", number(*watchdog), "must be 10 ms to 1 h, or 0 for none");
  return watchdog;
}

void read_body(TomlReader& top, MachineSpec& machine) {
  spec_detail::require_version(top);
  (void)top.text("kind");
  (void)top.optional_text("name");
  machine.watchdog = read_watchdog(top);
  const auto folder = std::filesystem::path(machine.document.name).parent_path();
  top.attempt([&] {
    top.for_each("axis",
                 [&](TomlReader& reader) { machine.axes.push_back(read_one(reader, folder)); });
    if (machine.axes.empty())
      top.fail("axis", "", "is missing: add [[axis]] with spec = \"FILE.toml\" for each axis");
  });
  top.attempt([&] {
    top.for_each("group",
                 [&](TomlReader& reader) { machine.groups.push_back(read_group(reader, folder)); });
  });
  top.attempt([&] { machine.masters = spec_detail::read_masters(top); });
  top.finish();
}

FollowWhom read_leader(TomlReader& table) {
  FollowWhom whom;
  if (table.has("axis") && table.has("master"))
    table.fail("axis", "", "cannot be combined with master: an axis follows one of the two");
  table.may_have("axis");
  table.may_have("master");
  if (!table.has("axis") && !table.has("master") && !table.is_faulty("axis"))
    table.fail("axis", "", "is missing: add axis = \"NAME\", or master = \"NAME\"");
  if (table.has("master")) {
    whom.master = table.text("master");
  } else {
    whom.axis = table.text("axis", "NAME");
    whom.actual = table.optional_choice("of", sides).value_or(0) == 1;
  }
  return whom;
}

}  // namespace

std::optional<FollowWhom> spec_detail::read_whom(TomlReader& owner) {
  auto table = owner.optional_table("follow");
  if (!table) return std::nullopt;
  FollowWhom whom = read_leader(*table);
  if (auto second = table->optional_table("second")) {
    whom.second.push_back(read_leader(*second));
    second->finish();
  }
  table->finish();
  return whom;
}

std::optional<MachineSpec> parse_machine(std::string text, std::string name) {
  if (spec_kind(text) != "machine") return std::nullopt;
  const Document document{std::move(name), std::move(text), {}, {}};
  const toml::table root = spec_detail::parse_toml(document);
  return spec_detail::read_document(root, [&](spec_detail::ErrorList& errors) {
    MachineSpec machine{.document = document, .axes = {}, .groups = {}, .masters = {}};
    TomlReader top(root, "", machine.document, &errors);
    top.attempt([&] { read_body(top, machine); });
    return machine;
  });
}

std::optional<MachineSpec> read_machine(const std::string& path) {
  return parse_machine(read_file(path), path);
}

}  // namespace jounce
