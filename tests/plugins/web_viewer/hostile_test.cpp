// SPDX-License-Identifier: BSD-3-Clause
// Malicious and broken clients are refused or disconnected, and the run is not affected.
#include <catch2/catch.hpp>
#include <thread>

#include "browser.hpp"
#include "watched_run.hpp"

namespace tolman::test {
namespace {

using namespace std::chrono_literals;

/// Checks that frames, pages and live clients still work.
void checkUnharmed(WatchedRun& watched) {
  watched.frames(5);
  CHECK(get(watched.port(), "/api/run").status == 200);
  LiveSocket socket(watched.port());
  REQUIRE(socket.status() == 101);
  REQUIRE(socket.next("hello"));
  watched.frames(1);
  CHECK(socket.next("frame"));
}

HttpAnswer raw(int port, const std::string& bytes) {
  Wire wire(port);
  wire.send(bytes);
  return readAnswer(wire);
}

int closeCodeAfter(int port, int first, const std::string& payload, bool masked = true) {
  LiveSocket socket(port);
  REQUIRE(socket.next("hello"));
  socket.sendFrame(first, payload, masked);
  for (;;) {
    const auto message = socket.next();
    if (!message) return 0;  // hung up without a word
    if (message->opcode == 8) return message->closeCode();
  }
}

}  // namespace

TEST_CASE("only GET and HEAD") {
  WatchedRun watched;
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "PATCH", "BREW"}) {
    CAPTURE(method);
    const HttpAnswer answer = get(watched.port(), "/api/run", method);
    CHECK(answer.status == 405);
    CHECK(answer.headers.at("allow") == "GET, HEAD");
  }
  CHECK(get(watched.port(), "/", "GET", "Content-Length: 5\r\n").status == 400);
  CHECK(raw(watched.port(),
            "GET / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n"
            "5\r\nhello\r\n0\r\n\r\n")
            .status == 400);
  checkUnharmed(watched);
}

TEST_CASE("paths outside the table are not found") {
  WatchedRun watched;
  for (const char* path :
       {"/../../../../etc/passwd", "/..%2f..%2fetc/passwd", "/assets/../index.html", "//etc/passwd",
        "/%2e%2e/plugin.cpp", "/./index.html", "/index.html/", "/assets/", "/.git/config",
        "/index.html%00.png", "/api", "/api/", "/api/../index.html", "/api/frame/../../x",
        "/INDEX.HTML", "/live/x"}) {
    CAPTURE(path);
    const int status = get(watched.port(), path).status;
    CHECK((status == 404 || status == 400));
  }
  CHECK(get(watched.port(), "http://127.0.0.1/").status == 400);
  CHECK(get(watched.port(), "*").status == 400);
  CHECK(get(watched.port(), "/live").status == 400);  // without an upgrade
  checkUnharmed(watched);
}

TEST_CASE("a foreign Host or Origin is refused, for pages and for the stream") {
  WatchedRun watched;
  const std::string own = "127.0.0.1:" + std::to_string(watched.port());
  CHECK(get(watched.port(), "/", "GET", "", "evil.example").status == 403);
  CHECK(get(watched.port(), "/api/run", "GET", "Origin: http://evil.example\r\n").status == 403);
  CHECK(get(watched.port(), "/api/run", "GET", "Origin: http://" + own + "\r\n").status == 200);
  CHECK(raw(watched.port(), "GET / HTTP/1.1\r\n\r\n").status == 400);
  CHECK(raw(watched.port(), "GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n")
            .status == 400);
  CHECK(raw(watched.port(), handshake("evil.example")).status == 403);
  CHECK(raw(watched.port(), handshake(own, "Origin: http://evil.example\r\n")).status == 403);
  CHECK(raw(watched.port(), handshake(own, "Origin: null\r\n")).status == 403);
  Wire wire(watched.port());
  wire.send(handshake(own, "Origin: http://" + own + "\r\n"));
  CHECK(readAnswer(wire, false).status == 101);
  checkUnharmed(watched);
}

TEST_CASE("the size of headers is limited") {
  WatchedRun watched;
  const std::string host = "Host: localhost\r\n";
  CHECK(
      raw(watched.port(), "GET / HTTP/1.1\r\n" + host + "X: " + std::string(9000, 'x') + "\r\n\r\n")
          .status == 431);
  CHECK(raw(watched.port(), "GET /" + std::string(100'000, 'a') + " HTTP/1.1\r\n" + host + "\r\n")
            .status == 431);
  std::string many = "GET / HTTP/1.1\r\n" + host;
  for (int i = 0; i < 2000; ++i) many += "H" + std::to_string(i) + ": 1\r\n";
  CHECK(raw(watched.port(), many + "\r\n").status == 431);
  checkUnharmed(watched);
}

TEST_CASE("malformed requests get 400 or no answer") {
  WatchedRun watched;
  RandomStream random(7);
  for (const char* bytes :
       {"\r\n\r\n\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n",
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", "\x16\x03\x01\x02\x00\x01\x00\x01\xfc",
        "GET / HTTP/1.1\nHost localhost\n\n", "GET  /  HTTP/1.1\r\n\r\n"}) {
    Wire wire(watched.port(), 0.3);
    wire.send(bytes);
    const HttpAnswer answer = readAnswer(wire);
    CAPTURE(bytes);
    CHECK((answer.status == 400 || answer.status == 0));
  }
  for (int i = 0; i < 100; ++i) {
    std::string noise(1 + random.below(300), '\0');
    for (char& c : noise) c = static_cast<char>(random.bits());
    Wire(watched.port()).send(noise);
  }
  checkUnharmed(watched);
}

TEST_CASE("malformed handshakes are refused") {
  WatchedRun watched;
  const std::string good = handshake("localhost");
  const auto without = [&](const std::string& line) {
    std::string text = good;
    const std::size_t at = text.find(line);
    REQUIRE(at != std::string::npos);
    return text.erase(at, text.find("\r\n", at) + 2 - at);
  };
  for (const char* line : {"Sec-WebSocket-Key", "Sec-WebSocket-Version", "Upgrade", "Connection"}) {
    CAPTURE(line);
    const int status = raw(watched.port(), without(line)).status;
    CHECK((status == 400 || status == 426));
  }
  std::string no_key = good;
  no_key.replace(no_key.find("dGhl"), 24, "");
  CHECK(raw(watched.port(), no_key).status == 400);
  std::string old = good;
  old.replace(old.find("Version: 13"), 11, "Version: 8 ");
  CHECK(raw(watched.port(), old).status != 101);
  std::string elsewhere = good;
  elsewhere.replace(0, 9, "GET /other");
  CHECK(raw(watched.port(), elsewhere).status == 404);
  checkUnharmed(watched);
}

TEST_CASE("invalid WebSocket frames close the connection") {
  WatchedRun watched;
  const std::string flow = R"({"type":"flow","live":true})";
  for (const int first : {0xf1, 0x83, 0x8b, 0x80, 0x09}) {  // reserved bits and opcodes, fragments
    CAPTURE(first);
    const int code = closeCodeAfter(watched.port(), first, flow);
    CHECK((code == 1002 || code == 0));
  }
  const int unmasked = closeCodeAfter(watched.port(), 0x81, flow, false);
  CHECK((unmasked == 1002 || unmasked == 0));
  const int text = closeCodeAfter(watched.port(), 0x81, "\xff\xfe");
  CHECK((text == 1007 || text == 0));
  checkUnharmed(watched);
}

TEST_CASE("unknown commands close with 1008") {
  WatchedRun watched;
  const char* const commands[] = {"",
                                  "{}",
                                  "[]",
                                  "null",
                                  "hello",
                                  "{\"type\":\"flow\"}",
                                  "{\"type\":\"flow\",\"live\":1}",
                                  "{\"type\":\"stop\",\"live\":true}",
                                  "{\"type\":\"flow\",\"live\":true,\"x\":0}",
                                  "[[[[[[[[[[[[[[[["};
  for (const char* command : commands) {
    CAPTURE(command);
    CHECK(closeCodeAfter(watched.port(), 0x81, command) == 1008);
  }
  CHECK(closeCodeAfter(watched.port(), 0x82, R"({"type":"flow","live":true})") == 1008);
  CHECK(closeCodeAfter(watched.port(), 0x81, std::string(4000, '[')) == 1008);
  checkUnharmed(watched);
}

TEST_CASE("too many commands close with 1008") {
  WatchedRun watched;
  LiveSocket socket(watched.port());
  REQUIRE(socket.next("hello"));
  for (int i = 0; i < 200; ++i) socket.sendText(R"({"type":"flow","live":true})");
  std::optional<LiveSocket::Message> message;
  while ((message = socket.next()) && message->opcode != 8) {
  }
  CHECK((!message || message->closeCode() == 1008));
  checkUnharmed(watched);
}

TEST_CASE("large messages are refused") {
  WatchedRun watched;
  const int code = closeCodeAfter(watched.port(), 0x81, std::string(5000, ' '));
  CHECK((code == 1009 || code == 0));
  LiveSocket socket(watched.port());
  REQUIRE(socket.next("hello"));
  // A frame that says it has 2^60 bytes.
  socket.wire().send(std::string("\x81\xff\x10\0\0\0\0\0\0\0\x01\x02\x03\x04", 14));
  std::optional<LiveSocket::Message> message;
  while ((message = socket.next()) && message->opcode != 8) {
  }
  CHECK((!message || message->closeCode() == 1009));
  checkUnharmed(watched);
}

TEST_CASE("two hundred clients that disconnect at every stage") {
  WatchedRun watched({{"rate", 200.0}});
  const std::string whole = handshake("localhost");
  for (std::size_t i = 0; i < 200; ++i) {
    Wire wire(watched.port());
    wire.send(whole.substr(0, i % 4 == 0 ? whole.size() : i));
    if (i % 8 == 0) (void)wire.receive(1 + i);
    if (i % 3 == 0) wire.reset();
    if (i % 5 == 0) watched.frames(1);
  }
  std::this_thread::sleep_for(50ms);
  checkUnharmed(watched);
}

TEST_CASE("the number of connections is limited") {
  WatchedRun watched({{"clients", std::int64_t{1}}});
  {
    std::vector<std::unique_ptr<Wire>> clients;
    for (int i = 0; i < 100; ++i) {
      clients.push_back(std::make_unique<Wire>(watched.port()));
      clients.back()->send("GET /");  // and never more
    }
    watched.frames(10);
    Wire late(watched.port(), 5);
    CHECK(late.isClosed());
  }
  std::this_thread::sleep_for(100ms);
  checkUnharmed(watched);
}

TEST_CASE("a stalled client delays neither the run nor its end") {
  WatchedRun watched({{"rate", 0.0}});
  const LiveSocket stalled(watched.port(), 10, 4096);
  LiveSocket reading(watched.port());
  REQUIRE(reading.next("hello"));
  std::thread reader([&] {
    while (const auto message = reading.next()) {
      if (message->opcode == 8) return;
    }
  });
  watched.frames(500);
  watched.finish();
  reader.join();
  CHECK(watched.shown() == 500);
}

TEST_CASE("unread responses delay neither the run nor its end") {
  WatchedRun watched({{"rate", 0.0}});
  watched.frames(2000, false);
  std::vector<std::unique_ptr<Wire>> greedy;
  for (int i = 0; i < 8; ++i) {
    greedy.push_back(std::make_unique<Wire>(watched.port(), 10, 4096));
    for (int k = 0; k < 50; ++k) {
      greedy.back()->send("GET /api/history HTTP/1.1\r\nHost: localhost\r\n\r\n");
    }
  }
  checkUnharmed(watched);
}

}  // namespace tolman::test
