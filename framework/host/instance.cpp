// SPDX-License-Identifier: BSD-3-Clause
#include "host/instance.hpp"

#include <span>
#include <sstream>
#include <utility>

#include "host/values.hpp"

namespace tolman::host {

void requireObject(const PluginObject& object, const Manifest& manifest) {
  if (object.plugin != nullptr) return;
  throw Refusal{"plugin/null-instance", "plugin '" + manifest.id + "' created no object",
                "let TOLMAN_PLUGIN write the factory"};
}

std::unique_ptr<Instance> Instance::create(const LoadedPlugin& plugin, std::string name) {
  PluginObject object;
  std::set<std::string> changed;
  const auto construct = [&] {
    object = plugin.descriptor->create();
    return Status::ok();
  };
  const Status status = guarded({name, plugin.manifest.id, "construct", -1}, construct, &changed);
  if (!status.isOk()) {
    throw Refusal{"plugin/create-failed", status.message(),
                  "a constructor must be cheap and must not throw: move work to configure()"};
  }
  requireObject(object, plugin.manifest);
  const auto destroy = [descriptor = plugin.descriptor](Plugin* constructed) {
    descriptor->destroy(constructed);
    return Status::ok();
  };
  auto made = std::make_unique<Instance>(plugin.manifest, std::move(name), object, destroy);
  made->changed_ = std::move(changed);
  return made;
}

Instance::Instance(Manifest manifest, std::string name, PluginObject object, Destroy destroy)
    : manifest_(std::move(manifest)),
      name_(std::move(name)),
      object_(object),
      destroy_(std::move(destroy)) {}

Instance::~Instance() { (void)destroy(); }

Status Instance::configure(const Context& context) {
  return call<Plugin>("configure", -1, [&](Plugin& p) { return p.configure(context); });
}

Status Instance::reset() {
  return call<Plugin>("reset", -1, [](Plugin& p) { return p.reset(); });
}

Status Instance::destroy() {
  Plugin* object = std::exchange(object_, PluginObject{}).plugin;
  if (object == nullptr) return Status::ok();
  return guardedCall("destroy", -1, [&] { return destroy_(object); });
}

Status Instance::arrays(std::int64_t frame, std::vector<NamedArray>& arrays) {
  arrays.clear();
  if (object_.arrays == nullptr) return Status::ok();
  return guardedCall("arrays", frame, [&] {
    object_.arrays->arrays(arrays);
    return shapes_.check(arrays);
  });
}

Status Instance::describe(std::vector<ArrayInfo>& arrays) {
  if (object_.descriptions == nullptr) return Status::ok();
  return guardedCall("describe", -1, [&] {
    const std::size_t before = arrays.size();
    const Status status = object_.descriptions->describe(arrays);
    if (!status.isOk() || arrays.size() < before) return status;
    return checkDescriptions(std::span(arrays).subspan(before));
  });
}

Status Instance::rawRig(RawRig& rig) {
  rig = {};
  if (object_.raw_rig == nullptr) return Status::ok();
  return guardedCall("rawRig", -1, [&] {
    const Status status = object_.raw_rig->rawRig(rig);
    if (!status.isOk()) return status;
    const Status values = checkValues(rig);
    return values.isOk() && rig.has_rectified ? checkRig(rig.rectified) : values;
  });
}

Result<std::string> Instance::url() {
  if (object_.page == nullptr) return unsupported("serves no page");
  std::string url;
  const Status status = guardedCall("url", -1, [&] {
    url = object_.page->url();
    return Status::ok();
  });
  if (!status.isOk()) return status;
  return url;
}

Status saveTo(std::ostream& stream, const StateKeeper& state) {
  const char* failed = "left its stream in a failed state; what it wrote is not complete";
  stream.exceptions(std::ios::badbit);  // or it would hide a lack of memory
  try {
    Status status = state.save(stream);
    return !status.isOk() || stream.good() ? status : Status::failed(failed);
  } catch (const std::ios::failure&) {
    return Status::failed(failed);
  }
}

Result<std::string> Instance::save() {
  if (object_.state == nullptr) return unsupported("cannot save its state");
  std::ostringstream stream;
  const Status status = guardedCall("save", -1, [&] { return saveTo(stream, *object_.state); });
  if (!status.isOk()) return status;
  return std::move(stream).str();
}

Status Instance::load(const std::string& bytes) {
  if (object_.state == nullptr) return unsupported("cannot save its state");
  std::istringstream stream(bytes);
  return guardedCall("load", -1, [&] { return object_.state->load(stream); });
}

Status Instance::unsupported(const std::string& what) const {
  return Status::unsupported(name_ + " (" + manifest_.id + "): this plugin " + what);
}

}  // namespace tolman::host
