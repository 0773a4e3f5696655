// SPDX-License-Identifier: BSD-3-Clause
// The page: the files of page/dist, compiled in.
#pragma once

#include <span>
#include <string_view>

namespace tolman::web_viewer {

struct BundleFile {
  std::string_view path;  ///< "index.html", "assets/main.js"
  std::string_view bytes;
};

std::span<const BundleFile> bundle();

/// Media type by the extension of the name; application/octet-stream for unknown extensions.
std::string_view mediaType(std::string_view path);

}  // namespace tolman::web_viewer
