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

/// A simulated line: the positions of a table over time, sent to executors as an external master.
namespace jounce {

struct LineMaster {
  std::string name;    ///< name of the master
  TableFile motion;    ///< over time, in s: line_motion()
  double rate = 1000;  ///< samples per second
  double before = 1;   ///< s at rest at the first point
  double after = 1;    ///< s at rest at the last point
  std::optional<double> seconds =
      {};  ///< ends then; nullopt: at the end of the table, if it has one
  std::optional<std::int32_t> epoch = {};  ///< nullopt: seconds since 2020
  EncoderErrors errors = {};               ///< errors of the encoder, in the unit of the motion
  std::optional<wire::Key> key = {};       ///< key of the executors; nullopt: none
};

/// Result of a transmission.
struct LineMasterResult {
  std::int64_t samples = 0;
  std::int64_t late = 0;  ///< instants that were left out
  double seconds = 0;     ///< time of the last sample
  double position = 0;    ///< position of the last sample, without the errors of the encoder
};

/// The table of an input over time, in s. nullopt for an input over a master.
std::optional<TableFile> line_motion(const Input& input);

/// Receives the time, s, the position and the share of the transmission, 0 if it has no end. Return
/// false to end it.
using LineProgress = std::function<bool(double time, double position, double share)>;

/// Sends samples at equal instants; one that is late is left out. At the end it reports the master as lost.
LineMasterResult send_line_master(Transport& link, const LineMaster& line,
                                  const LineProgress& keep_going = {});

/// The result in one line of text, and as a JSON object.
std::string line_master_text(const LineMaster& line, const LineMasterResult& result);
std::string line_master_json(const LineMaster& line, const LineMasterResult& result);

/// True if another sender uses this name: it listens for 0.3 s. A second one would replace the
/// first, even the line itself.
bool has_sender(Transport& link, const std::string& master,
                const std::optional<wire::Key>& key = {});

}  // namespace jounce
