// SPDX-License-Identifier: BSD-3-Clause
// tolman report: figures and one self-contained page about runs, from their records.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/exit_code.hpp"
#include "app/program.hpp"
#include "app/report_files.hpp"

namespace tolman::app {

void addReportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("report", "Figures and a page about runs (finished, running or killed)");
  auto runs = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  command->add_option("run", *runs, "Run directories; several stand side by side")->required();
  command->add_option("--out", *out, "Folder to write to (default: the first run directory)");
  command->callback([runs, out, &invocation] {
    const std::filesystem::path folder = out->empty() ? runs->front() : *out;
    const auto written = writeReport({runs->begin(), runs->end()}, folder);
    if (!written.isOk()) {
      std::cerr << written.status().message() << "\n";
      invocation.exit_code = static_cast<int>(ExitCode::Dataset);
    } else if (!invocation.quiet) {
      for (const auto& file : written.value()) std::cout << file.string() << "\n";
    }
  });
}

}  // namespace tolman::app
