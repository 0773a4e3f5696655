// SPDX-License-Identifier: BSD-3-Clause
// The response to each request target, independent of sockets.
#pragma once

#include <string>
#include <string_view>

#include "run_store.hpp"

namespace tolman::web_viewer {

struct HttpResponse {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  bool cacheable = false;
};

/// `target`: as in the request line. Paths are looked up in a table, never opened as files.
HttpResponse respond(std::string_view method, std::string_view target, const RunStore& store);

HttpResponse errorResponse(unsigned status);

}  // namespace tolman::web_viewer
