// SPDX-License-Identifier: BSD-3-Clause
#include "browser.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace tolman::test {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(c));
  return text;
}

std::uint64_t bigEndian(const std::string& bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

std::size_t sizeOf(const std::string& dtype) {
  const std::map<std::string, std::size_t> sizes = {{"u8", 1}, {"i32", 4}, {"f32", 4}, {"f64", 8}};
  REQUIRE(sizes.contains(dtype));
  return sizes.at(dtype);
}

}  // namespace

Wire::Wire(int port, double seconds, int receive_buffer)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  if (receive_buffer > 0) {
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  }
  timeval time{};
  time.tv_sec = static_cast<time_t>(seconds);
  time.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof time);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof time);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
}

Wire::~Wire() { ::close(socket_); }

bool Wire::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool Wire::fill() {
  std::array<char, 65536> piece{};
  const ssize_t n = ::recv(socket_, piece.data(), piece.size(), 0);
  if (n > 0) buffer_.append(piece.data(), static_cast<std::size_t>(n));
  return n > 0;
}

std::optional<std::string> Wire::receive(std::size_t size) {
  while (buffer_.size() < size) {
    if (!fill()) return std::nullopt;
  }
  std::string bytes = buffer_.substr(0, size);
  buffer_.erase(0, size);
  return bytes;
}

std::optional<std::string> Wire::receiveUntil(std::string_view mark) {
  std::size_t at = 0;
  while ((at = buffer_.find(mark)) == std::string::npos) {
    if (!fill()) return std::nullopt;
  }
  return receive(at + mark.size());
}

std::string Wire::receiveAll() {
  while (fill()) {
  }
  return std::exchange(buffer_, {});
}

bool Wire::isClosed() {
  while (fill()) {
  }
  char byte = 0;
  const ssize_t n = ::recv(socket_, &byte, 1, MSG_DONTWAIT);
  return n == 0 || (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK);
}

void Wire::reset() {
  const linger abrupt = {1, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &abrupt, sizeof abrupt);
  ::close(std::exchange(socket_, -1));
}

HttpAnswer readAnswer(Wire& wire, bool with_body) {
  HttpAnswer answer;
  const auto head = wire.receiveUntil("\r\n\r\n");
  if (!head) return answer;
  REQUIRE(head->starts_with("HTTP/1."));
  answer.status = std::stoi(head->substr(9, 3));
  for (std::size_t at = head->find("\r\n") + 2; at + 2 < head->size();) {
    const std::size_t end = head->find("\r\n", at);
    const std::string line = head->substr(at, end - at);
    const std::size_t colon = line.find(':');
    answer.headers[lower(line.substr(0, colon))] = line.substr(colon + 2);
    at = end + 2;
  }
  if (!with_body || !answer.headers.contains("content-length")) return answer;
  const auto body = wire.receive(std::stoul(answer.headers["content-length"]));
  REQUIRE(body);
  answer.body = *body;
  return answer;
}

HttpAnswer get(int port, const std::string& target, const std::string& method,
               const std::string& more_headers, const std::string& host) {
  Wire wire(port);
  const std::string name = host.empty() ? "127.0.0.1:" + std::to_string(port) : host;
  wire.send(method + " " + target + " HTTP/1.1\r\nHost: " + name + "\r\n" + more_headers + "\r\n");
  return readAnswer(wire, method != "HEAD");
}

Container parseContainer(const std::string& message) {
  REQUIRE(message.size() >= 4);
  std::uint32_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    length |= static_cast<std::uint32_t>(static_cast<unsigned char>(message[i])) << (8 * i);
  }
  REQUIRE(4 + std::size_t{length} <= message.size());
  Container container;
  container.header = nlohmann::json::parse(message.substr(4, length));
  const std::size_t payload = (4 + std::size_t{length} + 7) / 8 * 8;
  for (std::size_t i = 4 + length; i < std::min(payload, message.size()); ++i) {
    CHECK(message[i] == 0);
  }
  for (const auto& entry : container.header.at("arrays")) {
    Container::Array array;
    array.dtype = entry.at("dtype");
    array.shape = entry.at("shape").get<std::vector<std::size_t>>();
    std::size_t size = sizeOf(array.dtype);
    for (const std::size_t side : array.shape) size *= side;
    const std::size_t offset = entry.at("offset");
    REQUIRE(offset % 8 == 0);
    REQUIRE(payload + offset + size <= message.size());
    array.bytes = message.substr(payload + offset, size);
    container.arrays[entry.at("name")] = std::move(array);
  }
  return container;
}

std::string handshake(const std::string& host, const std::string& more, const std::string& target) {
  return "GET " + target + " HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
         more + "\r\n";
}

int LiveSocket::Message::closeCode() const {
  return opcode == 8 && bytes.size() >= 2 ? static_cast<int>(bigEndian(bytes.substr(0, 2))) : -1;
}

LiveSocket::LiveSocket(int port, double seconds, int receive_buffer, const std::string& target)
    : wire_(port, seconds, receive_buffer) {
  wire_.send(handshake("127.0.0.1:" + std::to_string(port), "", target));
  const HttpAnswer answer = readAnswer(wire_, false);
  status_ = answer.status;
  // RFC 6455's own example of key and answer.
  if (status_ == 101) {
    CHECK(answer.headers.at("sec-websocket-accept") == "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
  }
}

std::optional<LiveSocket::Message> LiveSocket::next() {
  Message message;
  for (;;) {
    const auto start = wire_.receive(2);
    if (!start) return std::nullopt;
    const auto first = static_cast<unsigned char>((*start)[0]);
    const auto second = static_cast<unsigned char>((*start)[1]);
    // Not by an assertion, which only one thread may have at a time (Catch2).
    if ((second & 0x80U) != 0) throw std::runtime_error("the server masked a message");
    std::uint64_t size = second;
    if (size >= 126) {
      const auto more = wire_.receive(size == 126 ? 2 : 8);
      if (!more) return std::nullopt;
      size = bigEndian(*more);
    }
    const auto payload = wire_.receive(size);
    if (!payload) return std::nullopt;
    const int opcode = first & 0x0fU;
    if (opcode == 9) {
      sendFrame(0x8a, *payload);
      continue;
    }
    if (opcode != 0) message.opcode = opcode;
    message.bytes += *payload;
    if ((first & 0x80U) != 0) return message;
  }
}

std::optional<Container> LiveSocket::next(const std::string& type) {
  for (;;) {
    const auto message = next();
    if (!message || message->opcode == 8) return std::nullopt;
    Container container = parseContainer(message->bytes);
    if (container.header["type"] == type) return container;
  }
}

void LiveSocket::sendText(const std::string& text) { sendFrame(0x81, text); }

void LiveSocket::sendFrame(int first, const std::string& payload, bool masked) {
  const std::string mask = "\x11\x22\x33\x44";
  std::string frame(1, static_cast<char>(first));
  const unsigned flag = masked ? 0x80 : 0;
  if (payload.size() < 126) {
    frame += static_cast<char>(flag | payload.size());
  } else {  // in two bytes or in eight, as short as can be
    const bool is_short = payload.size() < 65536;
    frame += static_cast<char>(flag | (is_short ? 126U : 127U));
    for (int shift = is_short ? 8 : 56; shift >= 0; shift -= 8) {
      frame += static_cast<char>(payload.size() >> static_cast<unsigned>(shift) & 0xffU);
    }
  }
  if (masked) frame += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame += static_cast<char>(payload[i] ^ (masked ? mask[i % 4] : 0));
  }
  wire_.send(frame);
}

}  // namespace tolman::test
