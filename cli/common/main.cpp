// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <cstdio>
#include <exception>
#include <system_error>

#include <fmt/format.h>

#include "jounce/about/standard_streams.hpp"
#include "jounce/base/detail/keep_freed_memory.hpp"
#include "jounce/base/detail/printable.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/stream/transport/transport.hpp"

#include "cli/common/verb.hpp"

namespace jounce::cli {
namespace {

int run(int argc, char** argv) {
  CommandLine line;
  for (const auto add :
       {add_new,      add_laws,     add_design,  add_check,    add_optimize,   add_sweep,
        add_validate, add_identify, add_diff,    add_convert,  add_fit,        add_plot,
        add_inverse,  add_map,      add_events,  add_contour,  add_report,     add_edit,
        add_stream,   add_master,   add_run,     add_replay,   add_monitor,    add_page,
        add_stop,     add_order,    add_explain, add_position, add_completion, add_man})
    add(line);
  return line.run(argc, argv);
}

/// Prints an error, which may contain any bytes of a file, of a file name or of a packet.
int complain(const char* prefix, const char* what, int status) {
  fmt::print(stderr, "jounce: {}{}\n", prefix, printable_lines(what));
  return status;
}

int flushed(int status) {
  const std::string error = jounce::flush_standard_output();
  return error.empty() ? status
                       : complain("cannot write to standard output: ", error.c_str(), fault);
}

}  // namespace
}  // namespace jounce::cli

int main(int argc, char** argv) {
  using namespace jounce::cli;
  jounce::keep_freed_memory();
  std::signal(SIGXFSZ,
              SIG_IGN);  // so write() reports a limit of the file size, like a full disk
  jounce::open_standard_streams();
  try {
    return flushed(run(argc, argv));
  } catch (const jounce::InputError& error) {
    return complain("", jounce::all_sentences(error, "jounce: ").c_str(), bad_input);
  } catch (const jounce::TransportError& error) {
    return complain("", error.what(), fault);
  } catch (const std::bad_alloc&) {
    return complain("", "out of memory", fault);
  } catch (const std::system_error& error) {
    return complain("", error.what(), fault);
  } catch (const std::exception& error) {
    return complain("internal fault: ", error.what(), fault);
  }
}
