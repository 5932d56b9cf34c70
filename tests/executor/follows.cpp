// SPDX-License-Identifier: Apache-2.0
// follows RECORD TABLE AXIS MASTER SLAVE_OFFSET: checks every cycle of the record in which AXIS
// runs coupled. Its setpoint is the table's cam at the position of MASTER in that cycle, to the
// last bit.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "jounce/cam/design/placement.hpp"
#include "jounce/executor/detail/replay.hpp"
#include "jounce/io/table_file.hpp"

namespace {

using namespace jounce;

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

int compare(const std::string& record, const std::string& table, const std::string& axis,
            const std::string& master, double slave_offset) {
  const TableFile file = read_table(table);
  const Table& cam = file.table;
  const double advance = cam.jet(cam.end(), Side::left)[0] - cam.jet(cam.start())[0];
  const Placement placement{
      .slave_offset = slave_offset, .advance = advance, .periodic = repeats(cam.outside())};
  std::ifstream names_in(record, std::ios::binary);
  const Replay names = replay(names_in, record);
  std::size_t a = 0, m = 0;
  while (names.axes.at(a).name != axis) ++a;
  while (names.masters.at(m).name != master) ++m;

  MasterReading sight;
  long equal = 0, other = 0, lost = 0;
  std::ifstream in(record, std::ios::binary);
  const Replay result = replay(
      in, record,
      [&](const RecordedCycle& c) {
        if (c.axis != a || c.tick.state != State::synchronized_motion ||
            c.tick.progress != Progress::running || sight.lost())
          return;
        const Jet exact = placed(cam, placement, sight.at);
        ++(same(exact[0], c.tick.position) && exact[1] == c.tick.velocity ? equal : other);
      },
      [&](const RecordedSight& s) {
        if (s.master != m) return;
        sight = s.sight;
        lost += sight.lost();
      });
  std::printf("%ld cycles in step, %ld otherwise; %ld without the master; replay %s\n", equal,
              other, lost, result.same() ? "the same" : "differs");
  return equal > 1000 && other == 0 && result.same() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  try {
    return compare(argv[1], argv[2], argv[3], argv[4], std::strtod(argv[5], nullptr));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "follows: %s\n", error.what());
    return 2;
  }
}
