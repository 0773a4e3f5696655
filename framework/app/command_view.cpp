// SPDX-License-Identifier: BSD-3-Clause
// tolman view: a run in the browser, finished or running, from its record.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "app/progress_line.hpp"
#include "engine/replay_server.hpp"
#include "engine/terminal.hpp"

namespace tolman::app {
namespace {

/// The port in "http://127.0.0.1:8080/"; 0 where there is none.
int portOf(std::string_view url) {
  int port = 0;
  const std::size_t colon = url.rfind(':');
  if (colon != std::string_view::npos) {
    std::from_chars(url.data() + colon + 1, url.data() + url.size(), port);
  }
  return port;
}

/// Serves a replay and prints the address of its page.
class ViewCommand {
 public:
  ViewCommand(const Invocation& invocation, bool hint) : invocation_(invocation), hint_(hint) {}

  void execute(const run::ReplayOptions& options) {
    const run::ReplayListener listener{[this](const std::string& url) { printAddress(url); },
                                       [this](std::int64_t frames) { beginLoading(frames); },
                                       [this] {
                                         if (progress_) progress_->step();
                                       },
                                       [this] { progress_.reset(); },
                                       [this](const std::string& text) { note(text); }};
    run::RunLog log;
    run::ReplayServer server(options, log, clock_, interrupts_, listener);
    server.serve();
  }

 private:
  void beginLoading(std::int64_t frames) {
    progress_ = std::make_unique<ProgressLine>(std::cerr, clock_, terminalOf(invocation_), frames);
  }

  void printAddress(const std::string& url) const {
    const int port = portOf(url);
    if (invocation_.json) {
      std::cout << nlohmann::ordered_json{{"url", url}, {"port", port}}.dump() << std::endl;
      return;
    }
    if (invocation_.quiet) return;
    std::cout << "watch at " << url << "  (Ctrl-C ends)" << std::endl;
    if (!hint_) return;
    std::cout << "from another machine: ssh -L " << port << ":localhost:" << port
              << " HOST, then open http://localhost:" << port << "/" << std::endl;
  }

  void note(const std::string& text) const {
    if (!invocation_.quiet)
      std::cerr << run::wipedLine(STDERR_FILENO) + run::printable(text) + "\n";
  }

  const Invocation& invocation_;
  bool hint_;
  run::Interrupts interrupts_;  // before anything that starts threads
  run::SteadyClock clock_;
  std::unique_ptr<ProgressLine> progress_;
};

}  // namespace

void addViewCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("view", "Show a run in the browser (finished, running or killed)");
  auto options = std::make_shared<run::ReplayOptions>();
  auto no_hint = std::make_shared<bool>(false);
  auto no_images = std::make_shared<bool>(false);
  command->add_option("run", options->run, "Run directory")->type_name("RUN")->required();
  command
      ->add_option("--viewer", options->viewer,
                   "Observer that serves the page (default: the first by id that can)")
      ->type_name("OBSERVER");
  command->add_option("--port", options->port, "TCP port (default: 8080 or a free one; 0: any)")
      ->check(CLI::Range(0, 65535));
  command->add_option("--bind", options->bind, "Address to listen on (default: 127.0.0.1)")
      ->type_name("ADDRESS");
  command->add_flag("--no-images", *no_images, "Do not read the images of the run's source again");
  command->add_flag("--no-browser-hint", *no_hint, "Print only the address");
  command->callback([options, no_hint, no_images, &invocation] {
    requireRun(options->run);
    options->plugin_paths = invocation.plugin_paths;
    options->images = !*no_images;
    if (const auto reader = record::RunReader::open(options->run); reader.isOk()) {
      warnOfChangedRecord(*reader.value());
    }
    ViewCommand view(invocation, !*no_hint);
    view.execute(*options);
  });
}

}  // namespace tolman::app
