// SPDX-License-Identifier: BSD-3-Clause
// Accepted and refused Host and Origin headers.
#include <catch2/catch.hpp>

#include "http_connection.hpp"

namespace tolman::web_viewer {

TEST_CASE("own host names are accepted with any port") {
  const auto local = boost::asio::ip::make_address("192.168.1.5");
  for (const char* host : {"localhost", "LocalHost:8080", "127.0.0.1:9", "127.1.2.3", "[::1]:8080",
                           "192.168.1.5", "192.168.1.5:65535"}) {
    CAPTURE(host);
    CHECK(isOwnHost(host, local));
  }
}

TEST_CASE("foreign and malformed host names are refused") {
  const auto local = boost::asio::ip::make_address("127.0.0.1");
  for (const char* host :
       {"", "evil.example", "evil.example:8080", "localhost.evil.example", "192.168.1.6",
        "127.0.0.1.", "127.0.0.1:port", "127.0.0.1:", "127.0.0.1:123456", "[::1", "[::1]x",
        "::1:8080", "0.0.0.0", "user@localhost", "localhost/", "2130706433"}) {
    CAPTURE(host);
    CHECK_FALSE(isOwnHost(host, local));
  }
}

TEST_CASE("an IPv4 address mapped to IPv6 is the same") {
  CHECK(isOwnHost("10.0.0.7:80", boost::asio::ip::make_address("::ffff:10.0.0.7")));
}

TEST_CASE("only the origin of the page is accepted") {
  CHECK(isOwnOrigin("http://localhost:8080", "localhost:8080"));
  CHECK(isOwnOrigin("http://LOCALHOST:8080", "localhost:8080"));
  for (const char* origin : {"http://localhost:8081", "http://127.0.0.1:8080",
                             "http://evil.example", "https://localhost:8080", "null",
                             "http://localhost:8080.evil.example", "http://localhost:8080/"}) {
    CAPTURE(origin);
    CHECK_FALSE(isOwnOrigin(origin, "localhost:8080"));
  }
}

}  // namespace tolman::web_viewer
