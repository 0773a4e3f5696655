// SPDX-License-Identifier: BSD-3-Clause
// What each address answers, apart from all sockets.
#pragma once

#include <string>
#include <string_view>

#include "gallery.hpp"

namespace tolman::web_viewer {

struct Answer {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  bool cacheable = false;
};

/// `target` as it stands in the request. Paths are looked up, never opened as files.
Answer answer(std::string_view method, std::string_view target, const Gallery& gallery);

Answer refusal(unsigned status);

}  // namespace tolman::web_viewer
