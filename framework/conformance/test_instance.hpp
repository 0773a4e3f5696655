// SPDX-License-Identifier: BSD-3-Clause
// The plugin under test with its parameters, and one instance of it. The instance is called as a
// host calls it; every answer is checked and hashed into a transcript.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "conformance/check_result.hpp"
#include "conformance/input_sequence.hpp"
#include "conformance/transcript.hpp"
#include "host/instance.hpp"

namespace tolman::conformance {

/// Called before each call into the plugin, so that the kit knows in which one the process died.
using Trace = std::function<void(const std::string& call)>;

struct Settings {
  ParameterValues values;            ///< of all parameters: defaults and --set
  std::vector<std::string> set;      ///< names of the parameters in --set
  std::vector<std::string> missing;  ///< required parameters without a value
  std::string problems;              ///< one line each
};

struct PluginUnderTest : Settings {
  host::LoadedPlugin loaded;
  std::uint64_t seed = 1;
  std::filesystem::path scratch;  ///< folder for files of the plugin
  Trace trace;

  Role role() const { return loaded.manifest.role; }
};

/// Calls one instance in its role, through the host's guarded stage, and checks answers against
/// those of earlier frames.
class RoleDriver {
 public:
  virtual ~RoleDriver() = default;
  /// One frame. A source ignores the input and gives its next frame.
  virtual Status process(const FrameInput& input, TranscriptEntry& answer) = 0;
  virtual Status finish(const InputSequence& sequence, TranscriptEntry& answer) = 0;
  /// Expects a new run: after configure() or reset().
  virtual void beginRun() = 0;
  /// Expects the run of `other` to continue here: its state was loaded into this instance.
  virtual void continueRun(const RoleDriver& other) = 0;
  virtual host::Instance& instance() = 0;
  /// Number of events that need a long drive, such as closed loops; an empty name for roles without
  /// such events.
  virtual Measurement reached() const { return {}; }
  void setRig(const CameraRig& rig) { rig_ = rig; }

 protected:
  CameraRig rig_;  ///< of the source of the run
};

std::unique_ptr<RoleDriver> makeDriver(Role role, std::unique_ptr<host::Instance> instance,
                                       const std::string& scratch);

/// One instance from construction to destruction.
class TestInstance {
 public:
  explicit TestInstance(const PluginUnderTest& plugin) : TestInstance(plugin, plugin.values) {}
  TestInstance(const PluginUnderTest& plugin, ParameterValues values);
  ~TestInstance();
  TestInstance(const TestInstance&) = delete;
  TestInstance& operator=(const TestInstance&) = delete;

  /// Also returns a failure of the constructor.
  Status configure(const CameraRig& rig);
  Status reset();
  Status process(const FrameInput& input);
  /// Processes inputs first ... last - 1, up to the first failure. A source gives as many frames.
  Status run(const InputSequence& sequence, std::size_t first = 0, std::size_t last = SIZE_MAX);
  Status finish(const InputSequence& sequence);
  Status destroy();

  Status save(std::ostream& stream);
  Status load(std::istream& stream);
  bool keepsState() const;
  Measurement reached() const { return driver_->reached(); }
  void continueRun(const TestInstance& other) { driver_->continueRun(*other.driver_); }
  /// Expects the answers of a new instance from now on: after reset() or a load() that failed.
  void beginRun();

  const Transcript& transcript() const { return transcript_; }
  void clearTranscript() { transcript_.clear(); }
  bool ended() const { return ended_; }  ///< the source returned EndOfStream

 private:
  struct Services;
  Status appendArrays(std::int64_t frame, TranscriptEntry& answer);

  const PluginUnderTest& plugin_;
  ParameterValues values_;
  std::unique_ptr<Services> services_;
  Status created_;
  std::unique_ptr<RoleDriver> driver_;
  Transcript transcript_;
  std::int64_t frames_ = 0;
  bool ended_ = false;
};

}  // namespace tolman::conformance
