#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "geometry/error.h"
#include "geometry/number_memory.h"
#include "hsr/cli/command_line.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/memory_limit.h"
#include "hsr/cli/messages.h"

namespace {

hsr::internal::UnfinishedFiles unfinished;  // global only because a signal handler has no other way to it

bool clears_line = false;  // standard error is a terminal, and may show a progress line

extern "C" void on_interrupt(int signal) {
  unfinished.remove_all();
  if (clears_line) [[maybe_unused]]
    const auto written = write(STDERR_FILENO, "\r\033[K", 4);
  _exit(128 + signal);
}

int fail(const std::string& message) {
  hsr::cli::tell("hsr: {}\n", message);
  return 2;
}

/// The library names what it refuses as the options are named, without the dashes.
std::string with_dashes(const std::string& message) {
  for (const std::string option :
       {"page",      "pen",    "scale",   "unit",  "margin",   "size",      "fov",     "near", "up",
        "direction", "eye",    "target",  "view",  "views",    "family",    "oblique", "only", "hide",
        "ghost",     "detail", "section", "depth", "overhead", "tolerance", "crease",  "edges"})
    if (message.rfind(option + ":", 0) == 0) return "--" + message;
  return message;
}

/// Declares all verbs and runs the one that is asked for.
void run(int argc, char** argv) {
  hsr::cli::CommandLine command(
      "hsr", "hsr: what is visible, exactly. Vector drawings of polygon models with hidden lines removed or dashed.",
      std::string("hsr ") + HSR_VERSION,
      "Exit status: 0 done; 1 a check failed; 2 bad usage or bad input.\n'hsr draw --help', or that of another verb, has its "
      "options, what it writes, and examples.");
  hsr::cli::add_draw(command, unfinished);
  hsr::cli::add_sheet(command, unfinished);
  hsr::cli::add_batch(command, unfinished);
  hsr::cli::add_split(command, unfinished);
  hsr::cli::add_tile(command, unfinished);
  hsr::cli::add_join(command, unfinished);
  hsr::cli::add_info(command, unfinished);
  hsr::cli::add_order(command, unfinished);
  hsr::cli::add_verify(command, unfinished);
  hsr::cli::add_compare(command, unfinished);
  hsr::cli::add_stability(command, unfinished);
  hsr::cli::add_explain(command, unfinished);
  hsr::cli::add_manual(command);
  command.run(argc, argv);
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) throw hsr::InputError("standard output: cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  clears_line = isatty(STDERR_FILENO) != 0;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGHUP, on_interrupt);
  std::signal(SIGXFSZ,
              SIG_IGN);  // a limit on the size of files: writing fails, one line says so, and no part of a file is left
  std::signal(SIGPIPE, SIG_IGN);  // who reads the standard output may stop: then writing fails, and one line says so
  try {
    hsr::cli::reserve_standard_streams();
    hsr::internal::throw_where_numbers_have_no_memory();
    hsr::cli::limit_memory_to_what_there_is();
    hsr::cli::keep_freed_memory();
    run(argc, argv);
    return 0;
  } catch (const hsr::cli::CheckFailed&) {
    return 1;
  } catch (const hsr::InputError& e) {
    return fail(with_dashes(e.what()));
  } catch (const std::bad_alloc&) {
    return fail(hsr::cli::out_of_memory());
  } catch (const std::system_error& e) {
    return fail(std::string("standard output: ") + e.what());
  } catch (const std::exception& e) {
    // How oneTBB says that there is no memory for another thread.
    if (std::string(e.what()).find("pthread_create") != std::string::npos) return fail(hsr::cli::out_of_memory());
    return fail(std::string("a defect of hsr, please report it: ") + e.what());
  }
}
