// SPDX-License-Identifier: BSD-3-Clause
// A plugin in a process of its own, through as many processes as it takes: when one dies and the
// policy is to restart, the next call starts another and brings it to where the last one stood.
// What it needs for that: the state that the plugin saved at the last checkpoint, and the calls
// since then. The call that was fatal is left out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "isolation/context_message.hpp"
#include "isolation/worker.hpp"
#include "plugins/manifest.hpp"

namespace tolman::isolation {

class Remote {
 public:
  /// Starts a process that loads the plugin. Refusals: those of loadPlugin(), plugin/died for a
  /// library that brings its process down, plugin/no-process.
  static plugins::OrRefusal<std::shared_ptr<Remote>> start(const plugins::Manifest& manifest,
                                                           const Launch& launch);
  /// Makes the plugin's object, once. Refusals: as Instance::create().
  std::optional<plugins::Refusal> create();
  /// Calls are kept from now on. False when this plugin cannot go on in a new process: a source
  /// would begin anew, and what places, cells or maps know would be lost unless they save it.
  bool enableRestart();

  const plugins::Manifest& manifest() const { return manifest_; }
  const Schema& schema() const { return schema_; }
  bool hasArrays() const { return has_arrays_; }
  bool hasState() const { return has_state_; }
  /// Whether the plugin lost its memory since this was asked last.
  bool takeAmnesia() { return std::exchange(amnesia_, false); }
  /// Whether the process outlived the last call.
  bool alive() const { return !worker_->gone(); }

  Status configure(const Context& context);
  template <class... I, class... O>
  Status call(Call call, std::tuple<const I&...> in, std::tuple<O&...> out) {
    return exchange(
        call,
        [&](Encoder& encoder) { std::apply([&](const auto&... v) { encoder.putAll(v...); }, in); },
        [&](Decoder& decoder) { std::apply([&](auto&... v) { decoder.getAll(v...); }, out); });
  }
  /// Ends the process when the plugin's object is destroyed.
  Status destroy();

 private:
  struct Kept {
    Call call;
    std::string request;
  };

  Remote(plugins::Manifest manifest, Launch launch)
      : manifest_(std::move(manifest)), launch_(std::move(launch)) {}
  std::optional<plugins::Refusal> load();
  Status exchange(Call call, const Worker::Write& write, const Worker::Read& read);
  Status revive();
  Status rebuild();
  Status mourn(const Status& status);
  Status replay(const std::vector<Kept>& calls);
  void keep(Call call);
  void checkpoint();

  plugins::Manifest manifest_;
  Launch launch_;
  Schema schema_;
  std::unique_ptr<Worker> worker_;
  bool created_ = false;
  bool has_arrays_ = false;
  bool has_state_ = false;
  Logger* log_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  bool restart_ = false;
  int restarts_ = 0;
  bool amnesia_ = false;
  std::string epitaph_;          ///< how the last process ended
  std::vector<Kept> beginning_;  ///< configure, artefacts, begin
  std::string checkpoint_;       ///< a saved state; empty for none
  std::vector<Kept> since_;      ///< calls since the checkpoint
};

}  // namespace tolman::isolation
