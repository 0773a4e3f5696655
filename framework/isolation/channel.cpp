// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tolman::isolation {
namespace {

struct Head {
  std::uint32_t kind;
  std::uint32_t detail;
  std::uint64_t size;
};

}  // namespace

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

bool Socket::send(const Note& note) const {
  Head head{note.kind, note.detail, note.size};
  // sendmsg() takes a pointer to what it does not change.
  std::array<iovec, 2> pieces{
      {{&head, sizeof head},
       {const_cast<char*>(note.text.data()), std::min(note.text.size(), kMostText)}}};
  msghdr message{};
  message.msg_iov = pieces.data();
  message.msg_iovlen = pieces.size();
  ssize_t sent = 0;
  do {
    sent = ::sendmsg(descriptor_.get(), &message, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

Wait Socket::receive(Note& note, std::chrono::milliseconds patience) const {
  pollfd watched{descriptor_.get(), POLLIN, 0};
  const int ready = ::poll(&watched, 1, static_cast<int>(patience.count()));
  if (ready == 0 || (ready < 0 && errno == EINTR)) return Wait::Nothing;
  Head head{};
  note.text.resize(kMostText);
  std::array<iovec, 2> pieces{{{&head, sizeof head}, {note.text.data(), note.text.size()}}};
  msghdr message{};
  message.msg_iov = pieces.data();
  message.msg_iovlen = pieces.size();
  const ssize_t bytes = ::recvmsg(descriptor_.get(), &message, 0);
  if (bytes < 0 && errno == EINTR) return Wait::Nothing;
  if (bytes < static_cast<ssize_t>(sizeof head)) return Wait::Gone;  // the end, or no note of ours
  note.kind = head.kind;
  note.detail = head.detail;
  note.size = head.size;
  note.text.resize(static_cast<std::size_t>(bytes) - sizeof head);
  return Wait::Note;
}

}  // namespace tolman::isolation
