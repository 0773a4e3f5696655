// SPDX-License-Identifier: BSD-3-Clause
// Values in the query of a request, in which a client may write any byte as %XX (RFC 3986, section
// 2.1), and a blank as + (forms of HTML).
#pragma once

#include <boost/asio/ip/address.hpp>
#include <charconv>
#include <string>
#include <string_view>

#include "run_store.hpp"

namespace tolman::web_viewer {

/// The value in plain text. A % without two hexadecimal digits stays.
inline std::string decodedValue(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned byte = 0;
    const char* digits = text.data() + at + 1;
    const bool coded = text[at] == '%' && at + 2 < text.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    plain += coded ? static_cast<char>(byte) : text[at] == '+' ? ' ' : text[at];
    if (coded) at += 2;
  }
  return plain;
}

// Checks of request headers, against web sites that make a browser send requests to this server
// (DNS rebinding, cross-site requests).

/// Whether a Host header names this server: localhost, a loopback address, or the address that the
/// connection was made to. Other host names are refused, because the DNS of any site can resolve to
/// this machine. The port is not compared, so that tunnels work.
bool isOwnHost(std::string_view host, const boost::asio::ip::address& local);

/// Whether an Origin header names the page that `host` serves.
bool isOwnOrigin(std::string_view origin, std::string_view host);

// The response to each request target, independent of sockets.

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
