// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "jounce/design/input.hpp"
#include "jounce/drive/encoder.hpp"
#include "jounce/stream/security/key.hpp"
#include "jounce/stream/transport/transport.hpp"

/// A simulated line: an external master that sends the positions of a table over time to executors.
namespace jounce {

struct LineMaster {
  std::string name = {};  ///< name of the master
  TableFile motion;       ///< table over time, in s; see line_motion()
  double rate = 1000;     ///< samples per second, > 0
  double before = 1;      ///< time at rest at the first point before the motion, s
  double after = 1;       ///< time at rest at the last point after the motion, s
  /// Duration of the transmission, including `before`, s. nullopt: the sum of `before`, the table
  /// and `after`; if the table repeats, the transmission has no end.
  std::optional<double> seconds = {};
  /// Number of the line's clock, MasterSample::clock; nullopt: seconds since 2020.
  std::optional<std::int32_t> epoch = {};
  EncoderErrors errors = {};  ///< errors of a simulated encoder, in the unit of the motion
  /// Key with which the executors authenticate samples; nullopt: none.
  std::optional<wire::Key> key = {};
};

/// Result of send_line_master().
struct LineMasterResult {
  std::int64_t samples = 0;  ///< number of samples sent
  std::int64_t late = 0;     ///< number of samples that were not sent because they were late
  double seconds = 0;        ///< time of the last sample, s
  double position = 0;       ///< last position, in the unit of the motion, without encoder errors
};

/// Returns the motion of an input as a table over time, in s; nullopt for an input over a master.
std::optional<TableFile> line_motion(const Input& input);

/// Receives the time (s), the position, and the share of the transmission that is done. The share
/// is 0 if the transmission has no end. To end the transmission, return false.
using LineProgress = std::function<bool(double time, double position, double share)>;

/// Sends samples at equal intervals. A sample that is late is not sent. At the end, sends several
/// messages that the master is lost. Throws InputError like EncoderReading.
LineMasterResult send_line_master(Transport& link, const LineMaster& line,
                                  const LineProgress& keep_going = {});

/// Returns the result as one line of text.
std::string line_master_text(const LineMaster& line, const LineMasterResult& result);
/// Returns the result as a JSON object.
std::string line_master_json(const LineMaster& line, const LineMasterResult& result);

/// True if another program sends a master of this name. The function receives until the first valid
/// sample, for at most 0.3 s. (A second sender would take the place of the first one, even if the
/// first one is the real line.)
bool has_sender(Transport& link, const std::string& master,
                const std::optional<wire::Key>& key = {});

}  // namespace jounce
