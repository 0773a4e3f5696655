// SPDX-License-Identifier: BSD-3-Clause
// The plugin under test with its parameters, and one instance of it, which is called as a host
// calls it. Its answers are checked, and kept as hashes of their fields to compare two runs bit by
// bit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/codec.hpp"
#include "conformance/input_sequence.hpp"
#include "conformance/kit.hpp"
#include "host/instance.hpp"
#include "tolman/fields.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// One answer: the call, and a hash for each field.
struct TranscriptEntry {
  std::string call;  ///< "frame 12"
  std::vector<std::pair<std::string, std::uint64_t>> fields;

  template <Record R>
  void add(const R& record) {
    visitFields(record, [this](const Field& field, const auto& value) {
      this->addValue(std::string(field.name), value);
    });
  }
  template <class T>
  void addValue(std::string name, const T& value) {
    fields.emplace_back(std::move(name), bitHash(value));
  }
};

using Transcript = std::vector<TranscriptEntry>;

/// "frame 12: 'T_previous_current'", or nothing when all bits agree. The first `skip` answers of
/// `expected` are ignored.
std::optional<std::string> firstDifference(const Transcript& expected, const Transcript& found,
                                           std::size_t skip = 0);

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

/// One instance from construction to destruction, called in its role through the host's guarded
/// stage. Answers are checked against those of earlier frames.
class TestInstance {
 public:
  /// Throws host::Refusal where the plugin makes no object.
  static std::unique_ptr<TestInstance> make(const PluginUnderTest& plugin, ParameterValues values);
  static std::unique_ptr<TestInstance> make(const PluginUnderTest& plugin) {
    return make(plugin, plugin.values);
  }
  virtual ~TestInstance() = default;
  TestInstance(const TestInstance&) = delete;
  TestInstance& operator=(const TestInstance&) = delete;

  /// `localise`: in a map that stays as it is; load() follows.
  Status configure(const CameraRig& rig, bool localise = false);
  Status reset();
  Status process(const FrameInput& input);
  /// Processes inputs first ... last - 1, up to the first failure. A source gives as many frames.
  Status run(const InputSequence& sequence, std::size_t first = 0, std::size_t last = SIZE_MAX);
  Status finish(const InputSequence& sequence);
  Status destroy();

  Result<std::string> save();
  Status load(const std::string& state);
  bool keepsState() { return instance().state() != nullptr; }
  const std::set<std::string>& changed() { return instance().changed(); }
  /// Events that need a long drive, such as closed loops; an empty name for roles without them.
  struct Reached {
    std::string name{};
    std::int64_t count = 0;
  };
  const Reached& reached() const { return reached_; }
  /// Expects the run of `other` to continue here: its state was loaded into this instance.
  void continueRun(const TestInstance& other);

  const Transcript& transcript() const { return transcript_; }
  void clearTranscript() { transcript_.clear(); }
  bool ended() const { return ended_; }  ///< the source returned EndOfStream

 protected:
  explicit TestInstance(const PluginUnderTest& plugin) : plugin_(plugin) {}
  virtual host::Instance& instance() = 0;
  /// One frame. A source ignores the input and gives its next frame.
  virtual Status answer(const FrameInput& input, TranscriptEntry& answer) = 0;
  virtual Status answerEnd(const InputSequence& sequence, TranscriptEntry& answer) = 0;
  /// Sets the state of the host's own checks to the progress of the run.
  virtual void resetChecks() = 0;
  /// The host's own checks of a Localiser.
  virtual void checkLocalised() = 0;
  /// Adds the call site to a failure that the kit found.
  Status checked(std::string_view call, std::int64_t frame, const Status& status);

  /// What the checks of a run need of its earlier frames.
  struct Progress {
    std::int64_t count = 0;              ///< frames of a source, templates, or experiences
    std::vector<std::int64_t> frames{};  ///< that a map has answered
  };
  const PluginUnderTest& plugin_;
  CameraRig rig_;  ///< of the source of the run
  Progress now_;
  Reached reached_;
  bool is_begun_ = false;  ///< info() of a source, or begin() of an observer, was called

 private:
  /// Expects a new run: after configure() or reset().
  void beginRun();
  Status appendArrays(std::int64_t frame, TranscriptEntry& answer);

  ParameterValues values_;
  Transcript transcript_;
  std::int64_t frames_ = 0;
  bool ended_ = false;
};

}  // namespace tolman::conformance
