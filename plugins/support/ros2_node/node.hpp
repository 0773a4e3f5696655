// SPDX-License-Identifier: BSD-3-Clause
// This process as a participant of DDS (Cyclone), as nodes of ROS 2 are: its topics, their
// publishers, and messages as bytes (CDR).
#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ros2_network.hpp"
#include "tolman/status.hpp"

namespace tolman::ros2_node {

using Bytes = std::span<const std::uint8_t>;

using source_parameters::Ros2Network;

/// How messages are delivered.
struct Delivery {
  bool reliable = false;  ///< lost ones are sent again
  bool kept = false;      ///< a later subscriber gets the last one ("transient local", latched)
  int depth = 10;         ///< messages that wait to be taken or sent
};

/// What others publish on a topic.
struct Offer {
  std::string type;      ///< "sensor_msgs/msg/Image"
  bool reliable = true;  ///< all publishers
  bool kept = true;      ///< all publishers
};

/// Messages of a topic. Valid as long as its node.
class Reader {
 public:
  explicit Reader(dds_entity_t reader) : reader_(reader) {}

  /// Calls with the bytes of each message that has come.
  void take(const std::function<void(Bytes)>& handle) const;
  /// Number of publishers that it receives from.
  std::size_t publishers() const;
  /// Whether there are publishers whose delivery is not the one that was asked for.
  bool hasUnfit() const;
  /// Number of messages that were lost on the way.
  std::size_t lost() const;

 private:
  dds_entity_t reader_;
};

/// A topic that this node publishes. Valid as long as its node.
class Writer {
 public:
  Writer(dds_entity_t writer, const ddsi_sertype* type) : writer_(writer), type_(type) {}
  /// Failed if the message cannot be sent now.
  Status write(Bytes message) const;

 private:
  dds_entity_t writer_;
  const ddsi_sertype* type_;
};

class Node {
 public:
  static Result<std::unique_ptr<Node>> start(const Ros2Network& network);
  ~Node();
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

  int domain() const { return domain_; }
  /// Topics that others publish, by name ("/front/image_raw").
  std::map<std::string, Offer> offers() const;
  Result<Reader> subscribe(const std::string& topic, const std::string& type, Delivery delivery);
  Result<Writer> advertise(const std::string& topic, const std::string& type, Delivery delivery);
  /// Waits until a message comes for one of the readers, at most for this time.
  void wait(std::int64_t longest_ns) const;

 private:
  Node(int domain, dds_entity_t participant);
  /// The topic, and its type within DDS.
  Result<std::pair<dds_entity_t, const ddsi_sertype*>> topic(const std::string& name,
                                                             const std::string& type);

  int domain_;
  dds_entity_t participant_;
  dds_entity_t publications_;  ///< reader of the topics that others publish
  dds_entity_t waitset_;
};

}  // namespace tolman::ros2_node
