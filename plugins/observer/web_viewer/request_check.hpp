// SPDX-License-Identifier: BSD-3-Clause
// Checks of request headers, against web sites that make a browser send requests to this server
// (DNS rebinding, cross-site requests).
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string_view>

namespace tolman::web_viewer {

/// Whether a Host header names this server: localhost, a loopback address, or the address that the
/// connection was made to. Other host names are refused, because the DNS of any site can resolve to
/// this machine. The port is not compared, so that tunnels work.
bool isOwnHost(std::string_view host, const boost::asio::ip::address& local);

/// Whether an Origin header names the page that `host` serves.
bool isOwnOrigin(std::string_view origin, std::string_view host);

}  // namespace tolman::web_viewer
