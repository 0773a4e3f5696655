// SPDX-License-Identifier: BSD-3-Clause
// The context of one check: the plugin, its input, and the messages to the kit; and the table of
// checks: each is one requirement on a plugin and the function that tests it.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/kit.hpp"
#include "conformance/test_instance.hpp"

namespace tolman::conformance {

/// What the process of one check is to do.
struct CheckTask : KitOptions {
  std::string check;
  std::filesystem::path folder;  ///< for its messages, and below it for files of the plugin
};
inline constexpr const char* kPluginFolder = "plugin";
inline constexpr const char* kOutputFile = "output";  ///< in `folder`: stdout and stderr

class CheckContext {
 public:
  using Send = std::function<void(const nlohmann::ordered_json&)>;

  /// `remedy` is added to warnings and errors that have none.
  CheckContext(CheckTask task, std::string_view remedy, Send send)
      : task_(std::move(task)), remedy_(remedy), send_(std::move(send)) {}

  const CheckTask& task() const { return task_; }

  /// Reads the manifest from the file without opening the library. Throws host::Refusal.
  host::Manifest manifest() const;
  /// The opened plugin with the values of --set. Throws host::Refusal.
  const PluginUnderTest& plugin();
  /// As plugin(), but skips the check when a required parameter has no value.
  const PluginUnderTest& completePlugin();

  /// Input for the role; from one camera if the plugin does not support two, with depth images if
  /// it is an odometry that does not support images alone.
  InputSequence sequence() { return makeSequence(sequenceOptions()); }
  /// A shorter sequence of the same rig: other images, other noise, fewer frames per circle.
  InputSequence otherSequence();
  SequenceOptions sequenceOptions();
  /// An instance that was constructed and configured for the rig. A failure ends the check.
  std::unique_ptr<TestInstance> configured(const CameraRig& rig);
  /// A new instance processes the sequence, finishes and is destroyed. A failure ends the check;
  /// `when` goes before its message.
  Transcript runOnce(const InputSequence& sequence, const std::string& when = {});

  /// Describes the input of the calls that follow: "draw 7 of seed 1".
  void currentInput(const std::string& description) const { send_({{"input", description}}); }
  void add(const Finding& finding) const;
  void error(const std::string& message, const std::string& remedy = {}) const {
    add({Finding::Severity::Error, {}, message, remedy});
  }
  void warning(const std::string& message, const std::string& remedy = {}) const {
    add({Finding::Severity::Warning, {}, message, remedy});
  }
  void note(const std::string& message) const { add({Finding::Severity::Note, {}, message}); }
  /// Ends the check, which throws its last finding.
  [[noreturn]] void skip(const std::string& reason) const;
  /// A failure ends the check likewise.
  void require(const Status& status, const std::string& when = {}) const;
  /// Time since the check began, as a share of its timeout.
  double timeUsed() const;

 private:
  /// Whether an odometry refuses the first frame of such a sequence, as Unsupported.
  bool needsDepth(SequenceOptions options);

  CheckTask task_;
  std::string remedy_;
  Send send_;
  std::optional<PluginUnderTest> plugin_;
  std::optional<bool> stereo_;
  std::optional<bool> depth_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// The values of --set, checked as the host checks a configuration. A required parameter without a
/// value is not a problem here; `missing` lists it.
Settings readSettings(const Schema& schema, const std::string& id,
                      const std::vector<std::string>& assignments);

/// Random legal values: about half of the parameters change, some to an end of their range; ranges
/// over two decades are sampled logarithmically. Draw number `index` of a seed, the same on every
/// machine. Values of --set stay.
ParameterValues randomParameters(const PluginUnderTest& plugin, std::uint64_t seed, int index);

/// The options that turn `base` into `drawn`: "--set a=1 --set b=false".
std::string difference(const ParameterValues& base, const ParameterValues& drawn);

/// Whether configure() has refused parameters or a rig.
inline bool isRefusal(const Status& status) {
  const StatusCode code = status.code();
  return code == StatusCode::InvalidParameter || code == StatusCode::Unsupported ||
         code == StatusCode::InvalidInput;
}

/// Roles as a bit mask.
constexpr unsigned bit(Role role) { return 1U << static_cast<unsigned>(role); }
inline constexpr unsigned kAllRoles = 0x3f;
inline constexpr unsigned kSource = bit(Role::Source);
inline constexpr unsigned kWithInput = kAllRoles & ~kSource;
inline constexpr unsigned kWithImages =
    bit(Role::Odometry) | bit(Role::Place) | bit(Role::Observer);

struct Check {
  std::string_view id;
  int level;       ///< lowest level that includes it: 1 contract, 2 reproducible results, 3 all
  unsigned roles;  ///< roles that it applies to, as bit()
  std::string_view demand;
  std::string_view remedy;  ///< for findings that give no remedy
  void (*run)(CheckContext&);
  bool same_images = false;  ///< needs the same images several times: not from a LiveSource
};

// The checks by topic.
std::span<const Check> declarationChecks();
std::span<const Check> lifeChecks();
std::span<const Check> inputChecks();

/// All checks in the order in which they run.
std::vector<Check> allChecks();

}  // namespace tolman::conformance
