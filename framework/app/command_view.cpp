// SPDX-License-Identifier: BSD-3-Clause
// tolman view: a run in the browser, finished or running, from its record.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "app/progress_line.hpp"
#include "app/view.hpp"

namespace tolman::app {
namespace {

/// What the terminal is told.
class ViewRun {
 public:
  ViewRun(Invocation& invocation, bool hint) : invocation_(invocation), hint_(hint) {}

  ExitCode execute(const ViewOptions& options) {
    const ViewListener listener{[this](const std::string& json) { tellAddress(json); },
                                [this](std::int64_t frames) { beginLoading(frames); },
                                [this] {
                                  if (progress_) progress_->step();
                                },
                                [this] { progress_.reset(); },
                                [this](const std::string& text) { note(text); }};
    View view(options, clock_, interrupts_, listener);
    const auto failure = view.serve();
    progress_.reset();
    return failure ? tell(*failure) : ExitCode::Ok;
  }

 private:
  void beginLoading(std::int64_t frames) {
    const Audience audience{isatty(STDERR_FILENO) == 1 && !invocation_.quiet, invocation_.quiet};
    progress_ = std::make_unique<ProgressLine>(std::cerr, clock_, audience, frames);
  }

  void tellAddress(const std::string& json) const {
    const auto address = nlohmann::ordered_json::parse(json, nullptr, false);
    if (!address.is_object() || !address.contains("url")) return;
    if (invocation_.json) {
      std::cout << address.dump() << std::endl;
      return;
    }
    if (invocation_.quiet) return;
    const std::string url = address["url"].get<std::string>();
    std::cout << "watch at " << url << "  (Ctrl-C ends)" << std::endl;
    if (!hint_) return;
    const std::string port = std::to_string(address.value("port", 0));
    std::cout << "from another machine: ssh -L " << port << ":localhost:" << port
              << " HOST, then open http://localhost:" << port << "/" << std::endl;
  }

  void note(const std::string& text) const {
    if (!invocation_.quiet) std::cerr << text << "\n";
  }

  Invocation& invocation_;
  bool hint_;
  Interrupts interrupts_;  // before anything that starts threads
  SteadyClock clock_;
  std::unique_ptr<ProgressLine> progress_;
};

}  // namespace

void addViewCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("view", "A run in the browser (finished, running or killed)");
  auto options = std::make_shared<ViewOptions>();
  auto quiet_hint = std::make_shared<bool>(false);
  auto no_images = std::make_shared<bool>(false);
  command->add_option("run", options->run, "Run directory")->required();
  command->add_option("--port", options->port, "TCP port (default: 8080 or a free one; 0: any)")
      ->check(CLI::Range(0, 65535));
  command->add_option("--bind", options->bind, "Address to listen on (default: 127.0.0.1)");
  command->add_flag("--no-images", *no_images, "Do not read the images of the run's source again");
  command->add_flag("--no-browser-hint", *quiet_hint, "Print the address and nothing else");
  command->callback([options, quiet_hint, no_images, &invocation] {
    options->plugin_paths = invocation.plugin_paths;
    options->images = !*no_images;
    ViewRun run(invocation, !*quiet_hint);
    invocation.exit_code = static_cast<int>(run.execute(*options));
  });
}

}  // namespace tolman::app
