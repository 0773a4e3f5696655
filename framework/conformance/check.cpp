// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/check.hpp"

#include "config/loader.hpp"
#include "config/values.hpp"

namespace tolman::conformance {

Settings readSettings(const Schema& schema, const std::string& id,
                      const std::vector<std::string>& assignments) {
  config::Node map{config::Node::Kind::Map};
  config::Problems problems;
  config::applyOverrides(map, assignments, config::processEnvironment(), problems);
  Settings settings;
  Schema lenient = schema;
  for (ParameterInfo& info : lenient) {
    if (map.find(info.name) != nullptr) {
      settings.set.push_back(info.name);
    } else if (info.required) {
      settings.missing.push_back(info.name);
    } else if (info.name == "quiet" && info.type == ParameterType::Bool) {
      info.default_value = true;  // checks show no progress on the terminal
      settings.set.push_back(info.name);
    }
    info.required = false;
  }
  const config::BaseFolders folders{std::filesystem::current_path(),
                                    config::processEnvironment()("HOME").value_or("")};
  settings.values = config::check(map, lenient, {"", "plugin " + id, {}}, folders, problems);
  settings.problems = problems.empty() ? "" : config::format(problems);
  return settings;
}

host::Manifest CheckContext::manifest() const {
  host::Manifest manifest = host::readManifest(task_.file, task_.id);
  manifest.program = task_.program_file;
  return manifest;
}

const PluginUnderTest& CheckContext::plugin() {
  if (plugin_) return *plugin_;
  const host::Manifest found = manifest();
  send_({{"call", "load"}});
  host::LoadedPlugin opened = host::loadPlugin(found, host::HostIdentity::ofThisBuild());
  const Trace trace = [this](const std::string& call) { send_({{"call", call}}); };
  return plugin_.emplace(PluginUnderTest{readSettings(opened.schema, task_.id, task_.set),
                                         std::move(opened), task_.seed,
                                         task_.folder / kPluginFolder, trace});
}

const PluginUnderTest& CheckContext::completePlugin() {
  const PluginUnderTest& found = plugin();
  std::string names;
  for (const std::string& name : found.missing) names += " --set " + name + "=...";
  if (!names.empty()) skip("a required parameter has no value; give" + names);
  return found;
}

SequenceOptions CheckContext::sequenceOptions() {
  SequenceOptions options = optionsFor(completePlugin().role(), task_.seed);
  if (!stereo_) {
    SequenceOptions one = options;
    one.frames = 1;
    one.images = false;
    const auto instance = TestInstance::make(*plugin_);
    const Status status = instance->configure(makeSequence(one).rig);
    stereo_ = status.code() != StatusCode::Unsupported;
  }
  options.stereo = *stereo_;
  if (!depth_) depth_ = plugin_->role() == Role::Odometry && needsDepth(options);
  options.depth = *depth_;
  return options;
}

bool CheckContext::needsDepth(SequenceOptions options) {
  options.frames = 1;
  const InputSequence sequence = makeSequence(options);
  const auto instance = TestInstance::make(*plugin_);
  return instance->configure(sequence.rig).isOk() &&
         instance->run(sequence).code() == StatusCode::Unsupported;
}

InputSequence CheckContext::otherSequence() {
  SequenceOptions options = sequenceOptions();
  ++options.seed;
  options.frames = 2 * options.frames / 3;
  options.turn = 3 * options.turn / 4;
  return makeSequence(options);
}

std::unique_ptr<TestInstance> CheckContext::configured(const CameraRig& rig) {
  auto instance = TestInstance::make(completePlugin());
  require(instance->configure(rig));
  return instance;
}

Transcript CheckContext::runOnce(const InputSequence& sequence, const std::string& when) {
  const auto instance = configured(sequence.rig);
  require(instance->run(sequence), when);
  require(instance->finish(sequence), when);
  require(instance->destroy(), when);
  return instance->transcript();
}

void CheckContext::add(const Finding& finding) const {
  const bool is_fault = finding.severity != Finding::Severity::Note;
  const std::string& remedy = finding.remedy.empty() && is_fault ? remedy_ : finding.remedy;
  send_(
      {{"severity", enumName(finding.severity)}, {"message", finding.message}, {"remedy", remedy}});
}

void CheckContext::skip(const std::string& reason) const {
  send_({{"skipped", true}});
  throw Finding{Finding::Severity::Note, {}, reason};
}

void CheckContext::require(const Status& status, const std::string& when) const {
  if (status.isOk()) return;
  const std::string text = when.empty() ? status.message() : when + ": " + status.message();
  throw Finding{Finding::Severity::Error, {}, text};
}

double CheckContext::timeUsed() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
  return seconds.count() / task_.timeout;
}

}  // namespace tolman::conformance
