// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "jounce/cam/design/design.hpp"
#include "jounce/spec/spec.hpp"

/// Changes of the text of a cam spec, as an editor makes them. Only the text of the change is
/// different in the result: comments, order and formatting stay.
namespace jounce {

/// Returns the text of a cam spec with the numbers, laws and names of `cam` in place of those that
/// differ. A number keeps the unit that the text gives to it ("12.5 cm"). A derivative that the
/// text gives with respect to time stays a derivative with respect to time. A value that only `cam`
/// has is added; a value that only the text has is removed. If the end of a line gives the speed
/// but no slave position, the speed changes instead of the position. Computed numbers have at most
/// 12 significant digits.
///
/// Requires that `cam` has as many segments as the spec. Throws InputError for a change of points
/// that are in another file, of a knot that such a file gives, and of the number of points.
std::string with_cam(const Spec& spec, const CamSpec& cam);

/// Returns the text of a cam spec with other positions of the switch with the index `at`: the key
/// `first_on_position` and, if the text has it, `last_on_position`, in the unit of the master.
/// Throws InputError for a switch that the text does not have.
std::string with_switch(const Spec& spec, std::size_t at, double first_on,
                        std::optional<double> last_on);

/// Returns the text of a cam spec with one more segment. The new segment gets the index `at`, from
/// 0 to the number of segments. Requires a text that parse_spec() accepts as a cam.
std::string with_segment(const std::string& text, std::size_t at, const CamSegment& segment);

/// Returns the text of a cam spec without the segment with the index `at`. Comments above the
/// segment stay. Requires a text that parse_spec() accepts as a cam, with another segment.
std::string without_segment(const std::string& text, std::size_t at);

}  // namespace jounce
