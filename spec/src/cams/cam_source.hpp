// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "jounce/spec/detail/toml_reader.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::spec_detail {

/// A cam from another file, with its units.
struct CamSource {
  NamedCam made;
  Units units;
  std::string time_unit = "s";
};

/// Reads the cam that the file under `key` describes: a spec of a cam or of a synchronous slave, or a
/// table over a master in any known format. The path is relative to the document. Throws InputError for a file
/// without a cam, for a table without units, and for a file that refers to itself.
CamSource read_cam_source(TomlReader& owner, const char* key);

/// Returns the cam in other units. Throws InputError, for `key`, if they are of other quantities.
NamedCam in_units(const CamSource& source, const Units& units, TomlReader& owner, const char* key);

}  // namespace jounce::spec_detail
