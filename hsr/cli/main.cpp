#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <new>

#include "geometry/error.h"
#include "hsr/cli/commands.h"

namespace {

hsr::UnfinishedFiles unfinished;  // global only because a signal handler has no other way to it

extern "C" void on_interrupt(int signal) {
  unfinished.remove_all();
  _exit(128 + signal);
}

/// A verb of a later release: its name is known, so that nobody looks for a typing error.
void add_later(CLI::App& app, const std::string& verb, const std::string& description) {
  CLI::App* sub = app.add_subcommand(verb, description + " (a later release)");
  sub->allow_extras();
  sub->callback([verb] { throw hsr::InputError(verb + ": comes in a later release; this one has draw and info"); });
}

int fail(const std::string& message) {
  fmt::print(stderr, "hsr: {}\n", message);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGHUP, on_interrupt);
  CLI::App app("hsr: what is visible, exactly. Vector drawings of polygon models with hidden lines removed or dashed.", "hsr");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("hsr ") + HSR_VERSION);
  app.footer("Exit status: 0 done; 1 a check failed; 2 bad usage or bad input.\n'hsr draw --help' has examples.");
  hsr::cli::add_draw(app, unfinished);
  hsr::cli::add_info(app, unfinished);
  add_later(app, "order", "Painter's order of the faces");
  add_later(app, "verify", "Is a painting order right?");
  add_later(app, "compare", "All methods on one scene");
  add_later(app, "stability", "Where each method and arithmetic breaks");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    return fail(std::string(e.what()) + " ('hsr --help' and 'hsr VERB --help' say what is)");
  } catch (const hsr::InputError& e) {
    return fail(e.what());
  } catch (const std::bad_alloc&) {
    return fail("out of memory: the scene does not fit");
  } catch (const std::exception& e) {
    return fail(std::string("a defect of hsr, please report it: ") + e.what());
  }
  return 0;
}
