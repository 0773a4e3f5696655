// SPDX-License-Identifier: BSD-3-Clause
// Replaces the source `ros2` in a build without DDS: it fails and names what is missing.
#include "ros2_parameters.hpp"
#include "tolman/extras.hpp"
#include "tolman/plugin.hpp"
#include "tolman/roles.hpp"

namespace tolman::ros2 {

class SourceWithoutRos final : public Source, public LiveSource {
 public:
  using Parameters = Ros2Parameters;

  Status configure(const Context&) override { return missing(); }
  Status reset() override { return missing(); }
  Status info(SourceInfo&) override { return missing(); }
  Status next(Frame&) override { return missing(); }

 private:
  static Status missing() {
    return Status::unsupported(
        "this build of Tolman has no ROS 2; install what `scripts/install-dependencies --ros` "
        "names, and build again");
  }
};

}  // namespace tolman::ros2

TOLMAN_PLUGIN(ros2, tolman::ros2::SourceWithoutRos, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 2.");
