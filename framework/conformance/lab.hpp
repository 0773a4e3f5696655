// SPDX-License-Identifier: BSD-3-Clause
// Where one check is made: the plugin, what it is shown, and a sheet for what is found.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "conformance/finding.hpp"
#include "conformance/specimen.hpp"

namespace tolman::conformance {

/// What the process of a check is told.
struct LabOptions {
  std::string file;
  std::string id;
  std::vector<std::string> set;  ///< "key=value"
  std::uint64_t seed = 1;
  int level = 3;
  std::filesystem::path scratch;
  double patience = 60;  ///< s until the kit ends this process
};

/// Ends a check early; what was found stands.
struct Stop {};

class Lab {
 public:
  using Sink = std::function<void(const Finding&)>;
  using FigureSink = std::function<void(const Figure&)>;

  /// `trace` hears of calls, `topic` of what they are about.
  Lab(LabOptions options, Trace trace, Trace topic, Sink finding, FigureSink figure)
      : options_(std::move(options)),
        trace_(std::move(trace)),
        topic_(std::move(topic)),
        finding_(std::move(finding)),
        figure_(std::move(figure)) {}

  const LabOptions& options() const { return options_; }
  /// What the calls from now on are about.
  void topic(const std::string& what) const { topic_(what); }

  /// From the file alone. Ends the check with the refusal when there is none.
  plugins::Manifest manifest() const;
  /// Opened, with the values of --set. Ends the check when it cannot be loaded.
  const Specimen& specimen();
  /// The same, and every required parameter is given; otherwise the check is skipped.
  const Specimen& complete();

  /// A drive for the role; with one camera if the plugin wants no two.
  Stimulus stimulus();
  StimulusOptions stimulusOptions();
  /// Constructed and configured for the rig; anything else ends the check.
  std::unique_ptr<Actor> living(const CameraRig& rig);

  void error(const std::string& message, std::string remedy = {}) const;
  void warning(const std::string& message, std::string remedy = {}) const;
  void note(const std::string& message) const { finding_({Severity::Ok, message, {}}); }
  [[noreturn]] void skip(const std::string& reason) const;
  [[noreturn]] void refuse(const plugins::Refusal& refusal) const;
  void figure(const std::string& name, double value, const std::string& unit) const {
    figure_({name, value, unit});
  }
  /// A failure becomes an error and ends the check.
  void demand(const Status& status, const std::string& when = {}) const;
  /// Seconds since the check began, as a share of the patience of the kit.
  double spent() const;

 private:
  LabOptions options_;
  Trace trace_;
  Trace topic_;
  Sink finding_;
  FigureSink figure_;
  std::optional<Specimen> specimen_;
  std::optional<bool> stereo_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// What --set says, checked as the host checks a configuration. What is required and not given is
/// no problem here; `lacking` lists it.
struct Settings {
  ParameterValues values;
  std::vector<std::string> set;
  std::vector<std::string> lacking;
  std::string problems;  ///< one line each; empty when all is well
};
Settings readSettings(const Schema& schema, const std::string& id,
                      const std::vector<std::string>& assignments);

}  // namespace tolman::conformance
