#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <new>

#include "geometry/error.h"
#include "hsr/cli/commands.h"
#include "hsr/cli/memory_limit.h"
#include "hsr/cli/messages.h"

namespace {

hsr::UnfinishedFiles unfinished;  // global only because a signal handler has no other way to it

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
       {"page", "scale", "unit", "margin", "size", "fov", "near", "up", "direction", "eye", "target", "view", "family"})
    if (message.rfind(option + ":", 0) == 0) return "--" + message;
  return message;
}

}  // namespace

int main(int argc, char** argv) {
  hsr::cli::reserve_standard_streams();
  hsr::cli::limit_memory_to_what_there_is();
  clears_line = isatty(STDERR_FILENO) != 0;
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGHUP, on_interrupt);
  CLI::App app("hsr: what is visible, exactly. Vector drawings of polygon models with hidden lines removed or dashed.", "hsr");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("hsr ") + HSR_VERSION);
  app.footer("Exit status: 0 done; 1 a check failed; 2 bad usage or bad input.\n'hsr draw --help' has examples.");
  hsr::cli::add_draw(app, unfinished);
  hsr::cli::add_info(app, unfinished);
  hsr::cli::add_order(app, unfinished);
  hsr::cli::add_verify(app, unfinished);
  hsr::cli::add_compare(app, unfinished);
  hsr::cli::add_stability(app, unfinished);
  const std::string verb = argc > 1 ? argv[1] : "";
  try {
    const auto verbs = app.get_subcommands([](const CLI::App*) { return true; });
    const bool known = std::any_of(verbs.begin(), verbs.end(), [&](const CLI::App* v) { return v->get_name() == verb; });
    if (!verb.empty() && verb.front() != '-' && !known)
      throw hsr::InputError(
          verb + ": no such verb, expected draw, order, verify, compare, stability or info ('hsr --help' lists them)");
    app.parse(argc, argv);
    std::cout.flush();
    if (std::fflush(stdout) != 0 || !std::cout) throw hsr::InputError("standard output: cannot be written");
    return 0;
  } catch (const CLI::Success& e) {
    const int status = app.exit(e);
    std::cout.flush();
    return std::cout ? status : fail("standard output: cannot be written");
  } catch (const hsr::cli::CheckFailed&) {
    return 1;
  } catch (const CLI::ParseError& e) {
    const bool known = !verb.empty() && verb.front() != '-';
    return fail(std::string(e.what()) + " (see 'hsr " + (known ? verb + " " : "") + "--help')");
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
