#include "hsr/cli/manual.h"

#include <iostream>
#include <memory>

#include "hsr/cli/commands.h"

namespace hsr::cli {

void add_manual(CommandLine& command) {
  command.add_hidden_verb("manual", "Print the manual page").on_run([&command] {
    std::cout << manual_page(command.description());
  });
  const auto shell = std::make_shared<std::string>();
  Options options = command.add_hidden_verb("completion", "Print what a shell completes options by");
  options.add("SHELL", *shell, "", "bash; zsh reads the same").required().one_of({"bash"});
  options.on_run([&command, shell] { std::cout << bash_completion(command.description()); });
}

}  // namespace hsr::cli
