// SPDX-License-Identifier: BSD-3-Clause
#include "bundle.hpp"

#include <array>
#include <utility>

namespace tolman::web_viewer {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kMediaTypes = {{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".wasm", "application/wasm"},
    {".txt", "text/plain; charset=utf-8"},
}};

}  // namespace

std::string_view mediaType(std::string_view path) {
  for (const auto& [ending, type] : kMediaTypes) {
    if (path.ends_with(ending)) return type;
  }
  return "application/octet-stream";
}

}  // namespace tolman::web_viewer
