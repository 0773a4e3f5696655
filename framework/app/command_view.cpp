// SPDX-License-Identifier: BSD-3-Clause
// tolman view: a run in the browser, finished or running, from its record.
#include <unistd.h>

#include <charconv>
#include <iostream>

#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "engine/replay_server.hpp"
#include "engine/services.hpp"

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

void printAddress(const std::string& url, bool hint, const Invocation& invocation) {
  const int port = portOf(url);
  if (invocation.json) {
    std::cout << nlohmann::ordered_json{{"url", url}, {"port", port}}.dump() << std::endl;
    return;
  }
  if (invocation.quiet) return;
  std::cout << "watch at " << url << "  (Ctrl-C ends)" << std::endl;
  if (!hint) return;
  std::cout << "from another machine: ssh -L " << port << ":localhost:" << port
            << " HOST, then open http://localhost:" << port << "/" << std::endl;
}

void view(const engine::ReplayOptions& options, bool hint, const Invocation& invocation) {
  const engine::Interrupts interrupts;  // before anything that starts threads
  const engine::SteadyClock clock;
  std::unique_ptr<ProgressLine> progress;
  const engine::ReplayListener listener{
      [&](const std::string& url) { printAddress(url, hint, invocation); },
      [&](std::int64_t frames) {
        progress = std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation), frames);
      },
      [&] {
        if (progress) progress->step();
      },
      [&] { progress.reset(); },
      [&](const std::string& text) {
        if (!invocation.quiet) std::cerr << engine::wipedLine(STDERR_FILENO) + text + "\n";
      }};
  engine::RunLog log;
  engine::ReplayServer(options, log, clock, interrupts, listener).serve();
}

}  // namespace

void addViewCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("view", "Show a run in the browser (finished, running or killed)");
  auto options = std::make_shared<engine::ReplayOptions>();
  auto no_hint = std::make_shared<bool>(false);
  auto no_images = std::make_shared<bool>(false);
  addArgument(command, "run", options->run, "RUN", "Run directory");
  addOption(command, "--viewer", options->viewer, "OBSERVER",
            "Observer that serves the page (default: the first by id that can)");
  addOption(command, "--port", options->port, "PORT",
            "TCP port (default: 8080 or a free one; 0: any)")
      ->check(CLI::Range(0, 65535));
  addOption(command, "--bind", options->bind, "ADDRESS",
            "Address to listen on (default: 127.0.0.1)");
  command.add_flag("--no-images", *no_images, "Do not read the images of the run's source again");
  command.add_flag("--no-browser-hint", *no_hint, "Print only the address");
  command.callback([options, no_hint, no_images, &invocation] {
    options->plugin_paths = invocation.plugin_paths;
    options->images = !*no_images;
    view(*options, !*no_hint, invocation);
  });
}

}  // namespace tolman::app
