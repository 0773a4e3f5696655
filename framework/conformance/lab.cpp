// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/lab.hpp"

#include <algorithm>

#include "config/check.hpp"
#include "config/overrides.hpp"

namespace tolman::conformance {

Settings readSettings(const Schema& schema, const std::string& id,
                      const std::vector<std::string>& assignments) {
  config::Node map;
  map.kind = config::Node::Kind::Map;
  config::Problems problems;
  config::applyOverrides(map, assignments, config::processEnvironment(), problems);
  Settings settings;
  Schema lenient = schema;
  for (ParameterInfo& info : lenient) {
    if (map.find(info.name) != nullptr) {
      settings.set.push_back(info.name);
    } else if (info.required) {
      settings.lacking.push_back(info.name);
    }
    info.required = false;
  }
  const config::Places places{std::filesystem::current_path(),
                              config::processEnvironment()("HOME").value_or("")};
  settings.values = config::check(map, lenient, {"", "plugin " + id, {}}, places, problems);
  settings.problems = problems.empty() ? "" : config::format(problems);
  return settings;
}

plugins::Manifest Lab::manifest() const {
  auto read = plugins::readManifest(options_.file, options_.id);
  if (const auto* refusal = std::get_if<plugins::Refusal>(&read)) refuse(*refusal);
  return std::move(std::get<plugins::Manifest>(read));
}

const Specimen& Lab::specimen() {
  if (specimen_) return *specimen_;
  const plugins::Manifest found = manifest();
  trace_("load");
  auto loaded = plugins::loadPlugin(found, plugins::HostIdentity::ofThisBuild());
  if (const auto* refusal = std::get_if<plugins::Refusal>(&loaded)) refuse(*refusal);
  Specimen specimen;
  specimen.plugin = std::move(std::get<plugins::LoadedPlugin>(loaded));
  Settings settings = readSettings(specimen.plugin.schema, options_.id, options_.set);
  specimen.values = std::move(settings.values);
  specimen.set = std::move(settings.set);
  specimen.lacking = std::move(settings.lacking);
  specimen.seed = options_.seed;
  specimen.scratch = options_.scratch;
  specimen.trace = trace_;
  specimen_ = std::move(specimen);
  return *specimen_;
}

const Specimen& Lab::complete() {
  const Specimen& found = specimen();
  std::string names;
  for (const std::string& name : found.lacking) names += " --set " + name + "=...";
  if (!names.empty()) skip("it needs a value that the kit cannot guess; give" + names);
  return found;
}

StimulusOptions Lab::stimulusOptions() {
  StimulusOptions options = optionsFor(complete().role(), options_.seed);
  if (!stereo_) {
    StimulusOptions one = options;
    one.frames = 1;
    one.images = false;
    Actor actor(*specimen_);
    const Status status = actor.configure(makeStimulus(one).rig);
    stereo_ = status.code() != StatusCode::Unsupported;
  }
  options.stereo = *stereo_;
  return options;
}

Stimulus Lab::stimulus() { return makeStimulus(stimulusOptions()); }

std::unique_ptr<Actor> Lab::living(const CameraRig& rig) {
  auto actor = std::make_unique<Actor>(complete());
  demand(actor->configure(rig));
  return actor;
}

void Lab::error(const std::string& message, std::string remedy) const {
  finding_({Severity::Error, message, std::move(remedy)});
}

void Lab::warning(const std::string& message, std::string remedy) const {
  finding_({Severity::Warning, message, std::move(remedy)});
}

void Lab::skip(const std::string& reason) const {
  finding_({Severity::Skip, reason, {}});
  throw Stop();
}

void Lab::refuse(const plugins::Refusal& refusal) const {
  error("[" + refusal.id + "] " + refusal.message, refusal.remedy);
  throw Stop();
}

void Lab::demand(const Status& status, const std::string& when) const {
  if (status.isOk()) return;
  error(when.empty() ? status.message() : when + ": " + status.message());
  throw Stop();
}

double Lab::spent() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
  return seconds.count() / options_.patience;
}

}  // namespace tolman::conformance
