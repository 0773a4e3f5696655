// SPDX-License-Identifier: BSD-3-Clause
// tolman init: looks at a recording and writes a configuration for it.
#include <iostream>

#include "app/options.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

struct InitCommand {
  std::string recording;
  Output out;
  std::string carrier;
  std::vector<std::string> values;
};

void init(const InitCommand& command, const Invocation& invocation) {
  SourceValues given;
  for (const std::string& text : command.values) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at == 0) {
      fail(ExitCode::Usage, "--set " + text + ": write it as NAME=VALUE");
    }
    given.emplace_back(text.substr(0, at), text.substr(at + 1));
  }
  const std::string& file = command.out.path;
  if (!file.empty()) refuseExisting({file}, command.out.replace, "--out");
  const std::string text = configurationFor(command.recording, given, command.carrier, invocation);
  if (file.empty()) {
    std::cout << text;
    return;
  }
  failUnless(record::writeOutput(file, text));
  printFiles({file}, invocation);
}

}  // namespace

void addInitCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("init", "Look at a recording, and write a configuration for it");
  auto options = std::make_shared<InitCommand>();
  addArgument(command, "recording", options->recording, "RECORDING",
              "Folder or file of the recording, or camera");
  options->out.add(command, "FILE", "File to write (default: standard output)", "Replace the file");
  addChoice(command, "--motion", options->carrier, {"car", "hand", "toy"},
            "What carries the camera (default: a guess)");
  addList(command, "--set", options->values, "NAME=VALUE",
          "Parameter of the source: --set a=b (repeatable)");
  command.callback([options, &invocation] { init(*options, invocation); });
}

}  // namespace tolman::app
