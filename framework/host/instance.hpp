// SPDX-License-Identifier: BSD-3-Clause
// Artefacts of one stage, in the host and in the process of an isolated stage.
#pragma once

#include <functional>
#include <iosfwd>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/guard.hpp"
#include "host/library.hpp"
#include "host/values.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

/// Writing fails until the run directory exists. It is created after configure(), when all checks
/// have passed.
class StageArtefacts : public ArtefactWriter {
 public:
  std::unique_ptr<ArtefactWriter> folder;

  Status write(std::string_view name, std::span<const std::byte> bytes) override {
    if (folder) return folder->write(name, bytes);
    return Status::failed("there is no run directory yet; write artefacts after configure()");
  }
};

// One plugin object behind the guard.

/// Throws the refusal plugin/null-instance if the factory of the plugin made no object.
void requireObject(const PluginObject& object, const Manifest& manifest);

/// Saves to the stream. Fails also if the plugin answers Ok but the stream has failed.
Status saveTo(std::ostream& stream, const StateKeeper& state);

class Instance {
 public:
  /// Constructs the plugin's object. `name` is the stage in the configuration. Refusals:
  /// plugin/create-failed, plugin/null-instance.
  static std::unique_ptr<Instance> create(const LoadedPlugin& plugin, std::string name);

  /// Destroys an object; an exception becomes the status.
  using Destroy = std::function<Status(Plugin*)>;
  /// Takes ownership of an object that was constructed elsewhere; `destroy` destroys it.
  Instance(Manifest manifest, std::string name, PluginObject object, Destroy destroy);

  /// Destroys the object under the guard and ignores exceptions; destroy() returns them.
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  Status configure(const Context& context);
  Status reset();
  Status destroy();

  const std::string& name() const { return name_; }
  const Manifest& manifest() const { return manifest_; }

  /// Replaces `arrays` by the plugin's state, with names and shapes of the first call; leaves it
  /// empty when it offers none.
  Status arrays(std::int64_t frame, std::vector<NamedArray>& arrays);
  /// Appends the descriptions of the plugin's arrays (for a source: of Frame::sensors); nothing
  /// when it offers none. After configure().
  Status describe(std::vector<ArrayInfo>& arrays);
  /// The cameras of a source before rectification; none where it gives rectified images. After
  /// its info().
  Status rawRig(RawRig& rig);
  /// Address of the page that an observer serves; Unsupported when it serves none. After begin().
  Result<std::string> url();
  /// Null when the plugin cannot save its state.
  StateKeeper* state() { return object_.state; }
  /// The state as bytes; Unsupported where there is none.
  Result<std::string> save();
  Status load(const std::string& bytes);

  /// Calls `work(role)` under the guard, with the object as its role.
  template <class RoleType, class Work>
  Status call(std::string_view what, std::int64_t frame, Work&& work) {
    return guardedCall(what, frame,
                       [&]() -> Status { return work(static_cast<RoleType&>(*object_.plugin)); });
  }
  /// What the calls so far changed in the process, and the guard restored.
  const std::set<std::string>& changed() const { return changed_; }

 private:
  template <class Work>
  Status guardedCall(std::string_view what, std::int64_t frame, Work&& work) {
    return guarded({name_, manifest_.id, what, frame}, std::forward<Work>(work), &changed_);
  }
  Status unsupported(const std::string& what) const;

  Manifest manifest_;
  std::string name_;
  PluginObject object_;
  Destroy destroy_;
  ArrayShapes shapes_;
  std::set<std::string> changed_;
};

}  // namespace tolman::host
