// SPDX-License-Identifier: Apache-2.0
#include "spec/src/cams/cam_source.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "jounce/base/file.hpp"
#include "jounce/base/units.hpp"
#include "jounce/controllers/exchange/exchange.hpp"
#include "jounce/io/table_file.hpp"

namespace jounce::spec_detail {
namespace {

/// The files that are being read, each because the one before it refers to it.
thread_local std::vector<std::string>
    open_files;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Adds a file to open_files while it is read.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path) { open_files.push_back(canonical(path)); }
  ~OpenFile() { open_files.pop_back(); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  static std::string canonical(const std::string& path) {
    std::error_code none;
    const auto whole = std::filesystem::weakly_canonical(path, none);
    return none ? path : whole.string();
  }
  static bool contains(const std::string& path) {
    return std::find(open_files.begin(), open_files.end(), canonical(path)) != open_files.end();
  }
};

std::string shown_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

CamSource of_table(const TableFile& file, const std::string& path, TomlReader& owner,
                   const char* key) {
  if (file.table.axis() != Domain::master)
    owner.fail(key, '"' + path + '"', "is a table over time: give a cam");
  if (file.units.x.empty() || file.units.position.empty())
    owner.fail(key, '"' + path + '"',
               "states no units: convert it first, with `jounce convert " + shown_name(path) +
                   " cam.csv --master-unit deg --position-unit mm`");
  Cam cam = file.table.curve<OverMaster>();
  std::vector<std::string> names(cam.segments().size(), shown_name(path));
  return {{std::move(cam), std::move(names)}, file.units};
}

/// The cam of a synchronous slave: of a shear, at the line speed of its spec.
CamSource of_sync(const SyncSpec& sync, const Spec& spec) {
  try {
    SyncCam made = sync_cam_of(sync);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < made.cam.segments().size(); ++i)
      names.push_back(std::to_string(i + 1) +
                      (i < made.segments.size() ? " " + made.segments[i] : ""));
    return {{std::move(made.cam), std::move(names)}, spec.units, spec.time_unit};
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

CamSource of_spec(const Spec& spec, const std::string& path, TomlReader& owner, const char* key) {
  if (!spec.over_master()) owner.fail(key, '"' + path + '"', "is a spec over time: give a cam");
  if (const auto* sync = std::get_if<SyncSpec>(&spec.subject)) return of_sync(*sync, spec);
  if (const auto* made = std::get_if<NamedCam>(&spec.subject))
    return {*made, spec.units, spec.time_unit};
  try {
    return {named(std::get<CamSpec>(spec.subject), spec.boundaries), spec.units, spec.time_unit};
  } catch (const InputError& error) {
    throw spec.document.located(error);
  }
}

}  // namespace

CamSource read_cam_source(TomlReader& owner, const char* key) {
  const std::string given = owner.text(key, "other.toml");
  const std::filesystem::path document = owner.document().name;
  const std::string path = (document.parent_path() / given).string();
  if (OpenFile::contains(path) ||
      OpenFile::canonical(path) == OpenFile::canonical(document.string()))
    owner.fail(key, '"' + given + '"',
               "refers back to this file: a cam cannot be made from itself");
  const OpenFile self(document.string());
  std::string text = owner.file_of(key, path, [&] { return read_file(path); });
  if (is_table(text)) return of_table(parse_table(text, path), given, owner, key);
  if (exchange_format_of_text(text) != nullptr)
    return of_table(parse_exchange(text, path), given, owner, key);
  const Spec source = parse_source(std::move(text), path);
  owner.record_files(source.document.files);
  return of_spec(source, given, owner, key);
}

NamedCam in_units(const CamSource& source, const Units& units, TomlReader& owner, const char* key) {
  for (const auto& [from, to] :
       {std::pair{&source.units.x, &units.x}, {&source.units.position, &units.position}})
    if (!is_convertible(*from, *to))
      owner.fail(key, '"' + owner.text(key) + '"',
                 std::string(from == &source.units.x ? "has a master in " : "has a slave in ") +
                     *from + ", which cannot be converted to " + *to + ", the unit of this cam");
  const double x = conversion(source.units.x, units.x);
  const double p = conversion(source.units.position, units.position);
  const NamedCam& made = source.made;
  if (x == 1 && p == 1) return made;
  return {scaled(made.cam, p, x), made.names, made.error * p, made.velocity_error * p / x};
}

}  // namespace jounce::spec_detail
