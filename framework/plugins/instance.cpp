// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/instance.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace tolman::plugins {

Refusal nullInstance(const Manifest& manifest) {
  return {"plugin/null-instance", "plugin '" + manifest.id + "' created nothing",
          "let TOLMAN_PLUGIN write the factory"};
}

OrRefusal<std::unique_ptr<Instance>> Instance::create(const LoadedPlugin& plugin,
                                                      std::string name) {
  PluginObject object;
  const Status status = guarded({name, plugin.manifest.id, "construct", -1}, [&] {
    object = plugin.descriptor->create();
    return Status::ok();
  });
  if (!status.isOk()) {
    return Refusal{"plugin/create-failed", status.message(),
                   "a constructor must be cheap and must not throw: move work to configure()"};
  }
  if (object.plugin == nullptr) {
    return nullInstance(plugin.manifest);
  }
  return adopt(plugin.manifest, std::move(name), object,
               [descriptor = plugin.descriptor](Plugin* doomed) {
                 descriptor->destroy(doomed);
                 return Status::ok();
               });
}

std::unique_ptr<Instance> Instance::adopt(Manifest manifest, std::string name, PluginObject object,
                                          Destroy destroy) {
  return std::unique_ptr<Instance>(
      new Instance(std::move(manifest), std::move(name), object, std::move(destroy)));
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
  Plugin* doomed = std::exchange(object_, PluginObject{}).plugin;
  if (doomed == nullptr) return Status::ok();
  return guarded({name_, manifest_.id, "destroy", -1}, [&] { return destroy_(doomed); });
}

Status Instance::arrays(std::int64_t frame, std::vector<NamedArray>& arrays) {
  arrays.clear();
  if (object_.arrays == nullptr) return Status::ok();
  return guarded({name_, manifest_.id, "arrays", frame}, [&] {
    object_.arrays->arrays(arrays);
    return checkArrays(arrays);
  });
}

Result<std::string> Instance::save() {
  if (object_.state == nullptr) return Status::unsupported(noState());
  std::ostringstream stream;
  const Status status =
      guarded({name_, manifest_.id, "save", -1}, [&] { return object_.state->save(stream); });
  if (!status.isOk()) return status;
  return std::move(stream).str();
}

Status Instance::load(const std::string& bytes) {
  if (object_.state == nullptr) return Status::unsupported(noState());
  std::istringstream stream(bytes);
  return guarded({name_, manifest_.id, "load", -1}, [&] { return object_.state->load(stream); });
}

std::string Instance::noState() const {
  return name_ + " (" + manifest_.id + "): this plugin cannot save its state";
}

Status Instance::checkArrays(const std::vector<NamedArray>& arrays) {
  for (const NamedArray& array : arrays) {
    std::size_t size = 1;
    for (const int side : array.shape) size *= static_cast<std::size_t>(std::max(side, 0));
    if (size != array.values.size()) {
      return Status::failed("array '" + array.name + "' has another size than its shape");
    }
    if (!std::all_of(array.values.begin(), array.values.end(),
                     [](float value) { return std::isfinite(value); })) {
      return Status::failed("array '" + array.name + "' has NaN or infinity");
    }
    const auto [known, is_new] = array_shapes_.try_emplace(array.name, array.shape);
    if (!is_new && known->second != array.shape) {
      return Status::failed("array '" + array.name + "' changed its shape");
    }
  }
  return Status::ok();
}

}  // namespace tolman::plugins
