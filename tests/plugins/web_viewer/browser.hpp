// SPDX-License-Identifier: BSD-3-Clause
// A test client on plain sockets, with separate parsers of HTTP, WebSocket and container, so that
// the server is not tested with its own library.
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

  /// False when the connection is closed.
  bool send(std::string_view bytes) const;
  /// Exactly `size` bytes; nothing at the end of the stream or after the time limit.
  std::optional<std::string> receive(std::size_t size);
  /// Everything up to and including `mark`.
  std::optional<std::string> receiveUntil(std::string_view mark);
  /// Everything until the connection is closed or the time limit.
  std::string receiveAll();
  /// Whether the server closes the connection within the time limit.
  bool isClosed();
  void reset();  ///< closes with a TCP reset

 private:
  bool fill();
  int socket_;
  std::string buffer_;
};

struct HttpAnswer {
  int status = 0;                              ///< 0: no response
  std::map<std::string, std::string> headers;  ///< names in lower case
  std::string body;
};

HttpAnswer readAnswer(Wire& wire, bool with_body = true);
HttpAnswer get(int port, const std::string& target, const std::string& method = "GET",
               const std::string& more_headers = "", const std::string& host = "");

/// A decoded container; its format is checked.
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

/// A WebSocket connection, to /live unless another target is given.
class LiveSocket {
 public:
  struct Message {
    int opcode = 0;  ///< 1 text, 2 binary, 8 close
    std::string bytes;
    int closeCode() const;
  };
  explicit LiveSocket(int port, double seconds = 10, int receive_buffer = 0,
                      const std::string& target = "/live");
  int status() const { return status_; }  ///< of the handshake
  /// The next message; answers pings. Nothing when the connection is closed.
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

std::string handshake(const std::string& host, const std::string& more = "",
                      const std::string& target = "/live");

}  // namespace tolman::test
