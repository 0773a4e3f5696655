// SPDX-License-Identifier: BSD-3-Clause
// A client made of nothing but sockets: HTTP, WebSocket and container are read here by hand, so
// that the server is not judged by its own library.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tolman::test {

/// A TCP connection to 127.0.0.1; reading waits for `seconds` at most.
class Wire {
 public:
  explicit Wire(int port, double seconds = 10, int receive_buffer = 0);
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  /// False when the other side has hung up.
  bool send(std::string_view bytes) const;
  /// Exactly so many bytes; nothing at the end or when time is up.
  std::optional<std::string> receive(std::size_t size);
  /// Up to and with `mark`.
  std::optional<std::string> receiveUntil(std::string_view mark);
  /// All that comes until the other side hangs up or time is up.
  std::string receiveAll();
  /// Whether the other side hangs up in time.
  bool isClosed();
  void reset();  ///< hangs up with a TCP reset

 private:
  bool fill();
  int socket_;
  std::string buffer_;
};

struct HttpAnswer {
  int status = 0;                              ///< 0: none came
  std::map<std::string, std::string> headers;  ///< names in small letters
  std::string body;
};

HttpAnswer readAnswer(Wire& wire, bool with_body = true);
HttpAnswer get(int port, const std::string& target, const std::string& method = "GET",
               const std::string& more_headers = "", const std::string& host = "");

/// What a container holds, with every promise of its form checked.
struct Container {
  struct Array {
    std::string dtype;
    std::vector<std::size_t> shape;
    std::string bytes;
    template <class T>
    std::vector<T> as() const {
      std::vector<T> values(bytes.size() / sizeof(T));
      std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
      return values;
    }
  };
  nlohmann::json header;
  std::map<std::string, Array> arrays;
  bool has(const std::string& name) const { return arrays.contains(name); }
};
Container parseContainer(const std::string& message);

/// A WebSocket that watches /live.
class LiveSocket {
 public:
  struct Message {
    int opcode = 0;  ///< 1 text, 2 binary, 8 close
    std::string bytes;
    int closeCode() const;
  };
  explicit LiveSocket(int port, double seconds = 10, int receive_buffer = 0);
  int status() const { return status_; }  ///< of the handshake
  /// Answers pings on the way; nothing when the connection is over.
  std::optional<Message> next();
  /// The next container of this type; others are skipped.
  std::optional<Container> next(const std::string& type);
  void sendText(const std::string& text);
  /// `first` is the byte with FIN and opcode.
  void sendFrame(int first, const std::string& payload, bool masked = true);
  Wire& wire() { return wire_; }

 private:
  Wire wire_;
  int status_ = 0;
};

std::string handshake(const std::string& host, const std::string& more = "");

}  // namespace tolman::test
