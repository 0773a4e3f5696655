// SPDX-License-Identifier: BSD-3-Clause
// Who may ask: against pages of other sites that make a browser talk to this server.
#pragma once

#include <boost/asio/ip/address.hpp>
#include <string_view>

namespace tolman::web_viewer {

/// Whether a Host header names this server: localhost, a loopback address, or the very address that
/// the connection came to. A name that somebody's DNS points here (rebinding) is none of them. The
/// port is free, for tunnels.
bool isOwnHost(std::string_view host, const boost::asio::ip::address& local);

/// Whether an Origin header is that of the page that `host` serves.
bool isOwnOrigin(std::string_view origin, std::string_view host);

}  // namespace tolman::web_viewer
