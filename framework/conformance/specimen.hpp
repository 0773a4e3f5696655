// SPDX-License-Identifier: BSD-3-Clause
// The plugin under test with its parameters, and one living instance of it, driven like a host
// would, with every answer checked and kept.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "conformance/stimulus.hpp"
#include "conformance/transcript.hpp"
#include "plugins/instance.hpp"

namespace tolman::conformance {

/// Told before each call into the plugin, so that it is known in which one a process died.
using Trace = std::function<void(const std::string& step)>;

struct Specimen {
  plugins::LoadedPlugin plugin;
  ParameterValues values;            ///< complete: defaults, and what the command line sets
  std::vector<std::string> set;      ///< names that the command line gave
  std::vector<std::string> lacking;  ///< required, and nobody gave them
  std::uint64_t seed = 1;
  std::filesystem::path scratch;  ///< a folder for what the plugin writes
  Trace trace;

  Role role() const { return plugin.manifest.role; }
};

/// Calls one instance in its role: the host's guarded stage, and what only a whole run can show.
class RoleDriver {
 public:
  virtual ~RoleDriver() = default;
  /// One frame. For a source the moment counts not: it gives its next frame.
  virtual Status work(const Moment& moment, Answer& answer) = 0;
  virtual Status finish(const Stimulus& stimulus, Answer& answer) = 0;
  /// Forgets the run, as after reset().
  virtual void begin() = 0;
  /// Remembers what `other` knows of its run: its state was loaded into this instance.
  virtual void resume(const RoleDriver& other) = 0;
  virtual plugins::Instance& instance() = 0;
  void setRig(const CameraRig& rig) { rig_ = rig; }

 protected:
  CameraRig rig_;  ///< of the source of the run
};

std::unique_ptr<RoleDriver> makeDriver(Role role, std::unique_ptr<plugins::Instance> instance,
                                       const std::string& scratch);

/// One life. Every call is told to the trace, every answer goes to the transcript.
class Actor {
 public:
  explicit Actor(const Specimen& specimen) : Actor(specimen, specimen.values) {}
  Actor(const Specimen& specimen, ParameterValues values);
  ~Actor();
  Actor(const Actor&) = delete;
  Actor& operator=(const Actor&) = delete;

  /// Failure of the constructor is what configure() then returns.
  Status configure(const CameraRig& rig);
  Status reset();
  Status work(const Moment& moment);
  /// All moments from `first` on, up to the first failure. A source gives as many frames.
  Status run(const Stimulus& stimulus, std::size_t first = 0, std::size_t last = SIZE_MAX);
  Status finish(const Stimulus& stimulus);
  Status destroy();

  Status save(std::ostream& stream);
  Status load(std::istream& stream);
  bool keepsState() const;
  void resume(const Actor& other) { driver_->resume(*other.driver_); }
  /// Expects answers as of a fresh instance, without a call: a load() that failed resets.
  void startAfresh();

  const Transcript& transcript() const { return transcript_; }
  void forget() { transcript_.clear(); }
  bool ended() const { return ended_; }  ///< a source said that there is no more

 private:
  struct Services;
  Status appendArrays(std::int64_t frame, Answer& answer);

  const Specimen& specimen_;
  ParameterValues values_;
  std::unique_ptr<Services> services_;
  Status created_;
  std::unique_ptr<RoleDriver> driver_;
  Transcript transcript_;
  std::int64_t frames_ = 0;
  bool ended_ = false;
};

}  // namespace tolman::conformance
