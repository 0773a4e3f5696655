// SPDX-License-Identifier: BSD-3-Clause
// The handlers of the calls that a plugin of a role supports. A handler decodes the arguments,
// calls the plugin under the guard, and encodes status and results.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "base/codec.hpp"
#include "host/child_process.hpp"
#include "host/guard.hpp"
#include "tolman/context.hpp"
#include "tolman/plugin.hpp"

namespace tolman::host {

using Handler = std::function<void(Decoder&, Encoder&)>;
using Handlers = std::map<Call, Handler>;

/// Handlers for the calls of the object's role and extras. The object must outlive them.
Handlers handlersOf(Role role, const PluginObject& object);

/// Whether a parameter of a call is a result: `T&` is one, any other type is an argument.
template <class P>
inline constexpr bool kIsResult =
    std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;

/// A handler that decodes the arguments, calls `work`, and encodes its status, and the results if
/// it is Ok.
template <class... P>
Handler handler(std::function<Status(P...)> work) {
  return [work](Decoder& in, Encoder& out) {
    std::tuple<std::remove_cvref_t<P>...> values;
    const auto decode = [&](auto& value, auto result) {
      if constexpr (!result.value) in.get(value);
    };
    std::apply([&](auto&... value) { (decode(value, std::bool_constant<kIsResult<P>>()), ...); },
               values);
    const Status status = contained([&] { return std::apply(work, values); });
    out.put(status);
    if (!status.isOk()) return;
    const auto encode = [&](const auto& value, auto result) {
      if constexpr (result.value) out.put(value);
    };
    std::apply(
        [&](const auto&... value) { (encode(value, std::bool_constant<kIsResult<P>>()), ...); },
        values);
  };
}

/// A handler that calls a method of `object`.
template <class Object, class Class, class... P>
Handler handler(Object& object, Status (Class::*method)(P...)) {
  return handler(std::function<Status(P...)>(
      [&object, method](auto&&... values) -> Status { return (object.*method)(values...); }));
}
template <class Object, class Class, class... P>
Handler handler(Object& object, Status (Class::*method)(P...) const) {
  return handler(std::function<Status(P...)>(
      [&object, method](auto&&... values) -> Status { return (object.*method)(values...); }));
}

/// Services of the plugin's context that are implemented outside of this folder.
struct ProcessServices {
  const Clock& clock;
  /// Creates the artefact writer of `instance` in the directory of a run.
  std::function<std::unique_ptr<ArtefactWriter>(const std::filesystem::path& run_directory,
                                                const std::string& instance)>
      artefacts;
};

/// `descriptor` of the socket is what ProcessHandle appends to its command. The process ends with
/// the host, without static destructors of the plugin.
[[noreturn]] void runPluginProcess(int descriptor, const ProcessServices& services);

}  // namespace tolman::host
