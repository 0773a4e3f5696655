// SPDX-License-Identifier: BSD-3-Clause
// What all connections share. Lives in the viewer's thread, and as long as the last connection.
#pragma once

#include <cstddef>
#include <set>

#include "gallery.hpp"

namespace tolman::web_viewer {

class LiveClient;

struct Hall {
  Hall(const Picture& picture, std::uint64_t spool_bytes, std::size_t most)
      : gallery(picture, spool_bytes), most_clients(most) {}

  Gallery gallery;
  std::size_t most_clients;
  std::size_t connections = 0;    ///< HTTP and live
  std::set<LiveClient*> clients;  ///< live; each signs in and out itself
  bool keeps_open = false;        ///< clients stay after the end of the run
};

}  // namespace tolman::web_viewer
