// SPDX-License-Identifier: BSD-3-Clause
#include "host/channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tolman::isolation {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    close();
    value_ = other.release();
  }
  return *this;
}

int Descriptor::release() { return std::exchange(value_, -1); }

void Descriptor::close() {
  if (value_ >= 0) ::close(release());
}

std::array<Socket, 2> Socket::pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "no socket");
  }
  return {Socket(Descriptor(ends[0])), Socket(Descriptor(ends[1]))};
}

bool Socket::send(const SocketMessage& message) const {
  MessageHead head = message;
  // sendmsg() does not change the text, but its pointer is not const.
  std::array<iovec, 2> pieces{
      {{&head, sizeof head},
       {const_cast<char*>(message.text.data()), std::min(message.text.size(), kMaxText)}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  ssize_t sent = 0;
  do {
    sent = ::sendmsg(descriptor_.get(), &header, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

ReceiveResult Socket::receive(SocketMessage& message, std::chrono::milliseconds timeout) const {
  pollfd watched{descriptor_.get(), POLLIN, 0};
  const int ready = ::poll(&watched, 1, static_cast<int>(timeout.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return ReceiveResult::Timeout;
  MessageHead& head = message;
  message.text.resize(kMaxText);
  std::array<iovec, 2> pieces{{{&head, sizeof head}, {message.text.data(), message.text.size()}}};
  msghdr header{};
  header.msg_iov = pieces.data();
  header.msg_iovlen = pieces.size();
  const ssize_t bytes = ::recvmsg(descriptor_.get(), &header, 0);
  if (bytes < 0 && errno == EINTR) return ReceiveResult::Timeout;
  if (bytes < static_cast<ssize_t>(sizeof head))
    return ReceiveResult::Closed;  // closed, or not a valid message
  message.text.resize(static_cast<std::size_t>(bytes) - sizeof head);
  return ReceiveResult::Message;
}

}  // namespace tolman::isolation
