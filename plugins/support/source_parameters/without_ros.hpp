// SPDX-License-Identifier: BSD-3-Clause
// What takes the place of a plugin of ROS in a build without: it has the same parameters, fails,
// and names what is missing.
#pragma once

#include <string>

#include "tolman/extras.hpp"
#include "tolman/roles.hpp"

namespace tolman::source_parameters {

/// `version`: of ROS.
inline Status withoutRos(int version) {
  return Status::unsupported("this build of Tolman has no ROS " + std::to_string(version) +
                             "; install what `scripts/install-dependencies --ros` names, and build "
                             "again");
}

template <class Declared, int version>
class SourceWithoutRos final : public Source, public LiveSource {
 public:
  using Parameters = Declared;

  Status configure(const Context&) override { return withoutRos(version); }
  Status reset() override { return withoutRos(version); }
  Status info(SourceInfo&) override { return withoutRos(version); }
  Status next(Frame&) override { return withoutRos(version); }
};

template <class Declared, int version>
class ObserverWithoutRos final : public Observer {
 public:
  using Parameters = Declared;

  Status configure(const Context&) override { return withoutRos(version); }
  Status reset() override { return withoutRos(version); }
  Status begin(const RunInfo&) override { return withoutRos(version); }
  Status observe(const Snapshot&) override { return withoutRos(version); }
  Status finish(const MapGraph&) override { return withoutRos(version); }
};

}  // namespace tolman::source_parameters
