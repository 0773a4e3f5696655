// SPDX-License-Identifier: BSD-3-Clause
#include "host/channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace tolman::host {

namespace {

struct Head {
  std::uint32_t kind;
  std::uint32_t detail;
  std::uint64_t size;
};

/// Whether all bytes came before the other end was closed.
bool readAll(int socket, void* bytes, std::size_t size) {
  auto* next = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t count = ::recv(socket, next, size, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

void Descriptor::close() {
  if (value_ >= 0) ::close(release());
}

std::array<Socket, 2> Socket::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "no socket");
  }
  return {Socket(Descriptor(ends[0])), Socket(Descriptor(ends[1]))};
}

bool Socket::send(const SocketMessage& message) const {
  const std::lock_guard lock(*sending_);
  Head head{message.kind, message.detail, message.bytes.size()};
  // Both pieces in one call, so that small messages of processes that share the socket stay whole.
  std::array<iovec, 2> pieces{
      {{&head, sizeof head}, {const_cast<char*>(message.bytes.data()), message.bytes.size()}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  while (pieces[0].iov_len + pieces[1].iov_len > 0) {
    const ssize_t sent = ::sendmsg(descriptor_.get(), &header, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    auto left = static_cast<std::size_t>(sent);
    for (iovec& piece : pieces) {
      const std::size_t done = std::min(left, piece.iov_len);
      piece.iov_base = static_cast<char*>(piece.iov_base) + done;
      piece.iov_len -= done;
      left -= done;
    }
  }
  return true;
}

ReceiveResult Socket::receive(SocketMessage& message, std::chrono::milliseconds timeout,
                              std::uint64_t most) const {
  pollfd watched{descriptor_.get(), POLLIN, 0};
  const int ready = ::poll(&watched, 1, static_cast<int>(timeout.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return ReceiveResult::Timeout;
  Head head{};
  if (!readAll(descriptor_.get(), &head, sizeof head)) return ReceiveResult::Closed;
  if (head.size > most) throw std::domain_error("it is larger than isolation.memory_limit");
  message.kind = head.kind;
  message.detail = head.detail;
  message.bytes.resize(head.size);
  const bool is_whole = readAll(descriptor_.get(), message.bytes.data(), head.size);
  return is_whole ? ReceiveResult::Message : ReceiveResult::Closed;
}

}  // namespace tolman::host
