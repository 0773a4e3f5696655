// SPDX-License-Identifier: BSD-3-Clause
// Replaces the source `ros1` in a build without ROS: it fails and names what is missing.
#include "ros1_parameters.hpp"
#include "tolman/extras.hpp"
#include "tolman/plugin.hpp"
#include "tolman/roles.hpp"

namespace tolman::ros1 {

class SourceWithoutRos final : public Source, public LiveSource {
 public:
  using Parameters = Ros1Parameters;

  Status configure(const Context&) override { return missing(); }
  Status reset() override { return missing(); }
  Status info(SourceInfo&) override { return missing(); }
  Status next(Frame&) override { return missing(); }

 private:
  static Status missing() {
    return Status::unsupported(
        "this build of Tolman has no ROS 1; install what `scripts/install-dependencies --ros` "
        "names, and build again");
  }
};

}  // namespace tolman::ros1

TOLMAN_PLUGIN(ros1, tolman::ros1::SourceWithoutRos, "0.1.0",
              "Images of one camera or a pair, live from topics of ROS 1.");
