// SPDX-License-Identifier: BSD-3-Clause
// Which calls a plugin of a role answers, and how: arguments out of the message, the call under the
// guard, the answers into the reply.
#pragma once

#include <functional>
#include <map>
#include <tuple>

#include "isolation/calls.hpp"
#include "isolation/codec.hpp"
#include "plugins/guard.hpp"
#include "tolman/plugin.hpp"

namespace tolman::isolation {

using Handler = std::function<void(Decoder&, Encoder&)>;
using Handlers = std::map<Call, Handler>;

/// The calls of the object's role and extras; the object must outlive them.
Handlers handlersOf(Role role, const PluginObject& object);

template <class... T>
struct Takes {};
template <class... T>
struct Gives {};

/// A handler that encodes the status of `work(taken..., given...)`, and the given when it is Ok.
template <class... I, class... O, class Work>
Handler handler(Takes<I...>, Gives<O...>, Work work) {
  return [work](Decoder& in, Encoder& out) {
    std::tuple<I...> taken;
    std::tuple<O...> given;
    std::apply([&](auto&... values) { in.getAll(values...); }, taken);
    const Status status = plugins::contained([&] {
      return std::apply(
          [&](auto&... from) {
            return std::apply([&](auto&... to) -> Status { return work(from..., to...); }, given);
          },
          taken);
    });
    out.put(status);
    if (status.isOk()) std::apply([&](const auto&... values) { out.putAll(values...); }, given);
  };
}

}  // namespace tolman::isolation
