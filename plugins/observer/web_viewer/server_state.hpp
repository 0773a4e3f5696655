// SPDX-License-Identifier: BSD-3-Clause
// State that all connections share. Belongs to the viewer's thread; lives as long as the last
// connection.
#pragma once

#include <cstddef>
#include <set>

#include "run_store.hpp"

namespace tolman::web_viewer {

class LiveClient;

struct ServerState {
  ServerState(const JpegOptions& jpeg_options, std::uint64_t spool_bytes, std::size_t most)
      : store(jpeg_options, spool_bytes), most_clients(most) {}

  RunStore store;
  std::size_t most_clients;
  std::size_t connections = 0;    ///< HTTP and live
  std::set<LiveClient*> clients;  ///< live; each registers itself
  bool keeps_open = false;        ///< connections are kept after the end of the run
};

}  // namespace tolman::web_viewer
