// SPDX-License-Identifier: BSD-3-Clause
// State that all connections share, used only in the viewer's thread. Each connection holds a
// reference.
#pragma once

#include <cstddef>
#include <functional>
#include <set>

#include "run_store.hpp"

namespace tolman::web_viewer {

class SocketClient;

struct ServerState {
  ServerState(const JpegOptions& jpeg_options, std::uint64_t spool_bytes, std::size_t most)
      : store(jpeg_options, spool_bytes), most_clients(most) {}

  RunStore store;
  std::size_t most_clients;
  std::size_t connections = 0;      ///< HTTP and live
  std::set<SocketClient*> clients;  ///< WebSocket clients; each registers itself
  std::size_t event_clients = 0;    ///< clients of /api/events
  std::function<void()> refresh;    ///< takes new data before an answer; empty in some tests
  bool keeps_open = false;          ///< connections are kept after the end of the run
};

}  // namespace tolman::web_viewer
