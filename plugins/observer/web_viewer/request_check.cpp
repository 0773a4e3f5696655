// SPDX-License-Identifier: BSD-3-Clause
#include "request_check.hpp"

#include <algorithm>
#include <string>

namespace tolman::web_viewer {
namespace {

std::string lower(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return small;
}

bool isPort(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The host without port and brackets of IPv6; empty when malformed.
std::string nameOf(std::string_view host) {
  std::string_view name = host;
  std::string_view rest;
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    name = host.substr(1, end - 1);
    rest = host.substr(end + 1);
  } else {
    const std::size_t colon = host.find(':');
    name = host.substr(0, colon);
    if (colon != std::string_view::npos) rest = host.substr(colon);
  }
  if (!rest.empty() && (rest[0] != ':' || !isPort(rest.substr(1)))) return {};
  return lower(name);
}

/// Turns ::ffff:1.2.3.4 into 1.2.3.4.
boost::asio::ip::address plain(const boost::asio::ip::address& address) {
  if (address.is_v6() && address.to_v6().is_v4_mapped()) {
    return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6());
  }
  return address;
}

}  // namespace

bool isOwnHost(std::string_view host, const boost::asio::ip::address& local) {
  const std::string name = nameOf(host);
  if (name == "localhost") return true;
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(name, error);
  if (error) return false;
  return address.is_loopback() || plain(address) == plain(local);
}

bool isOwnOrigin(std::string_view origin, std::string_view host) {
  return lower(origin) == "http://" + lower(host);
}

}  // namespace tolman::web_viewer
