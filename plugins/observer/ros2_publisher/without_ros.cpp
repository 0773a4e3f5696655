// SPDX-License-Identifier: BSD-3-Clause
// Replaces the observer `ros2_publisher` in a build without DDS: it fails and names what is
// missing.
#include "publisher_parameters.hpp"
#include "tolman/plugin.hpp"
#include "tolman/roles.hpp"

namespace tolman::ros2_publisher {

class PublisherWithoutRos final : public Observer {
 public:
  using Parameters = PublisherParameters;

  Status configure(const Context&) override { return missing(); }
  Status reset() override { return missing(); }
  Status begin(const RunInfo&) override { return missing(); }
  Status observe(const Snapshot&) override { return missing(); }
  Status finish(const MapGraph&) override { return missing(); }

 private:
  static Status missing() {
    return Status::unsupported(
        "this build of Tolman has no ROS 2; install what `scripts/install-dependencies --ros` "
        "names, and build again");
  }
};

}  // namespace tolman::ros2_publisher

TOLMAN_PLUGIN(ros2_publisher, tolman::ros2_publisher::PublisherWithoutRos, "0.1.0",
              "Publishes odometry, transforms, map and state as topics of ROS 2.");
