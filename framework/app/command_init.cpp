// SPDX-License-Identifier: BSD-3-Clause
// tolman init: looks at a recording and writes a configuration for it.
#include <linux/magic.h>
#include <sys/vfs.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "app/init_text.hpp"
#include "app/named_value.hpp"
#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/system_options.hpp"
#include "base/open_files.hpp"
#include "record/atomic_file.hpp"
#include "record/output_places.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecording = "a recording";

struct InitOptions {
  std::string recording;
  std::string out;
  CarriedBy carrier = CarriedBy::Unknown;
  std::vector<std::string> values;
  bool replace = false;
};

/// Splits texts "name=value".
SourceValues splitValues(const std::vector<std::string>& texts) {
  refuseTwoValues(texts);
  SourceValues values;
  for (const std::string& text : texts) {
    const std::size_t at = text.find('=');
    if (at == std::string::npos || at == 0) {
      throw Ended{ExitCode::Usage, "--set " + text + ": write it as NAME=VALUE"};
    }
    values.emplace_back(text.substr(0, at), text.substr(at + 1));
  }
  return values;
}

std::string unreadText(const std::string& recording, const RecordingSearch& search) {
  constexpr int kFilesOfProbe = 4;
  if (file_opening::areDescriptorsShort(kFilesOfProbe)) {
    return recording + ": " + file_opening::kNotOpened;
  }
  const PathKind kind = kindOf(recording);
  const bool is_recording = kind == PathKind::Recording || kind == PathKind::ImageFolder ||
                            kind == PathKind::Bag || kind == PathKind::Image;
  const bool is_other = !is_recording && kind != PathKind::Missing && kind != PathKind::Unknown &&
                        kind != PathKind::Folder;
  if (is_other) return wrongKindText(recording, kind, kRecording);
  std::string text = recording + ": no source reads it";
  for (const std::string& reason : search.reasons) text += "\n  " + reason;
  return text + "\nParameters are given by --set NAME=VALUE; see docs/your-camera.md";
}

/// Refuses runs and sweeps, whose figures are images that a source would read.
void refuseRuns(const fs::path& recording, const std::string& given) {
  const PathKind kind = kindOf(recording);
  if (kind == PathKind::Run || kind == PathKind::Sweep || kind == PathKind::Point) {
    throw Ended{ExitCode::Dataset, wrongKindText(given, kind, kRecording)};
  }
  const std::optional<fs::path> run = record::runAround(recording);
  if (!run || record::refuseRunPlaces(recording, "", *run).isOk()) return;
  throw Ended{ExitCode::Dataset, given + ": belongs to the run " + run->string() +
                                     ", and is not a recording; name the folder or file of one"};
}

/// Whether a file lies in a file system that the kernel makes up, such as /proc or /sys.
bool isOfKernel(const fs::path& path) {
  constexpr std::array<long, 7> kMadeUp = {PROC_SUPER_MAGIC,    SYSFS_MAGIC,   CGROUP_SUPER_MAGIC,
                                           CGROUP2_SUPER_MAGIC, DEBUGFS_MAGIC, TRACEFS_MAGIC,
                                           BPF_FS_MAGIC};
  struct statfs system {};
  return ::statfs(path.c_str(), &system) == 0 &&
         std::ranges::find(kMadeUp, static_cast<long>(system.f_type)) != kMadeUp.end();
}

std::string shippedText(const std::string& name) {
  std::ifstream file(configFile("configs/init/" + name));
  std::ostringstream text;
  text << file.rdbuf();
  if (text.str().empty()) {
    throw Ended{ExitCode::Configuration,
                "configs/init/" + name + " is not there; install the program again"};
  }
  return text.str();
}

ExitCode init(const InitOptions& options, const Invocation& invocation) {
  std::error_code error;
  const fs::path recording = fs::canonical(options.recording, error);
  if (error) return printFailure(ExitCode::Dataset, options.recording + ": " + error.message());
  if (isOfKernel(recording)) {
    return printFailure(ExitCode::Dataset,
                        options.recording +
                            ": lies in a file system of the kernel (such as /proc or /sys), which "
                            "holds no recording; name the folder or file of a recording");
  }
  refuseRuns(recording, options.recording);
  if (!options.out.empty()) refuseExisting({options.out}, options.replace, "--out");
  const RecordingSearch search =
      searchRecording(recording, splitValues(options.values), invocation);
  if (!search.best) {
    return printFailure(ExitCode::Dataset, unreadText(options.recording, search));
  }
  const Probe& best = *search.best;
  const CarriedBy used =
      options.carrier == CarriedBy::Unknown ? guessCarrier(best) : options.carrier;
  const std::string text =
      initText(recording, search, options.carrier, shippedText(stagesFile(best, used)));
  if (options.out.empty()) {
    std::cout << text;
    return ExitCode::Ok;
  }
  requireOrEnd(record::writeOutput(options.out, text));
  printFiles({options.out}, invocation);
  return ExitCode::Ok;
}

}  // namespace

void addInitCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("init", "Look at a recording, and write a configuration for it");
  auto options = std::make_shared<InitOptions>();
  command->add_option("recording", options->recording, "Folder or file of the recording, or camera")
      ->type_name("RECORDING")
      ->required();
  command->add_option("--out", options->out, "File to write (default: standard output)")
      ->type_name("FILE")
      ->check(notEmpty);
  const std::vector<std::pair<std::string, CarriedBy>> carriers = {
      {"car", CarriedBy::Car}, {"hand", CarriedBy::Hand}, {"toy", CarriedBy::Toy}};
  command->add_option("--motion", options->carrier, "What carries the camera (default: a guess)")
      ->type_name("car|hand|toy")
      ->transform(CLI::Validator(namedValue(carriers), ""));
  command->add_option("--set", options->values, "Parameter of the source: --set a=b (repeatable)")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  addForce(*command, options->replace, "Replace the file");
  command->callback([options, &invocation] { invocation.exit_code = init(*options, invocation); });
}

}  // namespace tolman::app
