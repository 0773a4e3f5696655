// SPDX-License-Identifier: BSD-3-Clause
#include "master_probe.hpp"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace tolman::ros1_node {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxAnswer = 64 << 10;  // bytes; a roscore's has 500
constexpr int kMaxValues = 100;               // a roscore's has 4
constexpr std::string_view kQuestion =
    "<?xml version=\"1.0\"?><methodCall><methodName>getPid</methodName><params><param>"
    "<value>/tolman</value></param></params></methodCall>";

class Connection {
 public:
  explicit Connection(Clock::time_point end) : end_(end) {}
  ~Connection() {
    if (socket_ >= 0) ::close(socket_);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool open(const std::string& host, std::uint32_t port) {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) {
      return false;
    }
    bool connected = false;
    for (const addrinfo* at = found; at != nullptr && !connected; at = at->ai_next) {
      connected = connectTo(*at);
    }
    ::freeaddrinfo(found);
    return connected;
  }

  bool send(std::string_view text) const {
    return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());  // it fits into the socket's buffer
  }

  /// Appends what comes next; false at the end, or when the time is over.
  bool receive(std::string& text) const {
    std::array<char, 4096> piece{};
    if (!waitFor(POLLIN)) return false;
    const ssize_t bytes = ::recv(socket_, piece.data(), piece.size(), 0);
    if (bytes > 0) text.append(piece.data(), static_cast<std::size_t>(bytes));
    return bytes > 0;
  }

  bool isLate() const { return Clock::now() >= end_; }

 private:
  bool connectTo(const addrinfo& address) {
    if (socket_ >= 0) ::close(socket_);
    socket_ = ::socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (socket_ < 0) return false;
    if (::connect(socket_, address.ai_addr, address.ai_addrlen) == 0) return true;
    int error = 0;
    socklen_t size = sizeof error;
    return errno == EINPROGRESS && waitFor(POLLOUT) &&
           ::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
  }

  bool waitFor(short event) const {
    for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - Clock::now());
      if (left.count() <= 0) return false;
      pollfd watched{socket_, event, 0};
      const int ready = ::poll(&watched, 1, static_cast<int>(left.count()));
      if (ready > 0) return true;
      if (ready < 0 && errno != EINTR) return false;
    }
  }

  Clock::time_point end_;
  int socket_ = -1;
};

/// The answer's XML; none while it is not complete.
std::optional<std::string_view> bodyOf(std::string_view answer) {
  constexpr std::string_view kEnd = "</methodResponse>";
  const std::size_t begin = answer.find("\r\n\r\n");
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t end = answer.find(kEnd, begin);
  if (end == std::string_view::npos) return std::nullopt;
  return answer.substr(begin, end + kEnd.size() - begin);
}

/// [1, text, number of a process].
bool isPid(std::string_view body) {
  int values = 0;
  for (std::size_t at = 0; (at = body.find("<value>", at)) != std::string_view::npos; ++at) {
    ++values;
  }
  return values >= 4 && values <= kMaxValues && body.find("<array>") != std::string_view::npos &&
         body.find("<int>") != body.find("<i4>") && body.find("<struct>") == std::string_view::npos;
}

}  // namespace

Status probeMaster(const std::string& uri, const std::string& host, std::uint32_t port,
                   std::chrono::milliseconds limit) {
  constexpr const char* kRemedy = "; start it (`roscore`), or set master to where it is";
  Connection connection(Clock::now() + limit);
  const std::string question =
      "POST /RPC2 HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port) +
      "\r\nContent-Type: text/xml\r\nContent-Length: " + std::to_string(kQuestion.size()) +
      "\r\nConnection: close\r\n\r\n" + std::string(kQuestion);
  if (!connection.open(host, port) || !connection.send(question)) {
    return Status::invalidInput("no roscore answers at " + uri + kRemedy);
  }
  std::string answer;
  while (!bodyOf(answer) && answer.size() < kMaxAnswer && connection.receive(answer)) {
  }
  const auto body = bodyOf(answer);
  if (body && isPid(*body)) return Status::ok();
  if (!body && connection.isLate()) {
    return Status::invalidInput("a program listens at " + uri + " and did not answer within " +
                                std::to_string(limit.count() / 1000) +
                                " s; the roscore hangs or is stopped, or it is another program: "
                                "start the roscore again, or set master to where it is");
  }
  return Status::invalidInput("what answers at " + uri + " is no roscore" + kRemedy);
}

}  // namespace tolman::ros1_node
