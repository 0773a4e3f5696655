// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "host/stages.hpp"
#include "host/values.hpp"

using namespace tolman;

namespace {

/// A pair like that of KITTI, with a change.
template <class Change>
Status checked(const Change& change) {
  CameraRig rig{1226, 370, true, {707.1, 707.1, 601.9, 183.1}, 0.54};
  change(rig);
  return host::checkRig(rig);
}

bool refuses(const Status& status, const std::string& text) {
  INFO(status.message());
  return status.code() == StatusCode::InvalidInput &&
         status.message().find(text) != std::string::npos;
}

/// A source whose left camera looks backwards.
struct BackwardSource : Source {
  using Parameters = NoParameters;
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status info(SourceInfo& info) override {
    info.rig = {64, 48, true, {-180, 180, 31.5, 23.5}, 0.5};
    return Status::ok();
  }
  Status next(Frame&) override { return Status::endOfStream(); }
};

}  // namespace

TEST_CASE("possible cameras are accepted: pairs, single ones, none, parts of images") {
  CHECK(checked([](CameraRig&) {}).isOk());
  CHECK(checked([](CameraRig& rig) { rig.baseline = 0; }).isOk());
  CHECK(host::checkRig({}).isOk());                                       // a motion log
  CHECK(host::checkRig({640, 480, false, {}, 0}).isOk());                 // not calibrated
  CHECK(host::checkRig({64, 64, true, {700, 700, 960, 540}, 0}).isOk());  // a corner
  CHECK(host::checkRig({1920, 32, true, {900, 900, 960, -500}, 0}).isOk());
  CHECK(checked([](CameraRig& rig) { rig.pinhole.fx = rig.pinhole.fy = 70000; }).isOk());
}

TEST_CASE("cameras that cannot be are refused, whatever source gives them") {
  for (const double focal : {0.0, -180.0}) {
    CHECK(refuses(checked([&](CameraRig& rig) { rig.pinhole.fx = focal; }), "focal lengths"));
    CHECK(refuses(checked([&](CameraRig& rig) { rig.pinhole.fy = focal; }), "focal lengths"));
  }
  CHECK(refuses(checked([](CameraRig& rig) { rig.baseline = -0.54; }), "is -0.54 m"));
  CHECK(refuses(checked([](CameraRig& rig) { rig.width = -1; }), "images of -1x370 px"));
  CHECK(refuses(checked([](CameraRig& rig) { rig.height = 0; }), "images of 1226x0 px"));
}

TEST_CASE("the source that gives impossible cameras is named") {
  static constexpr PluginDescriptor kDescriptor = {0,
                                                   1,
                                                   "backward",
                                                   Role::Source,
                                                   0,
                                                   &schemaOf<NoParameters>,
                                                   &detail::createPlugin<BackwardSource>,
                                                   [](Plugin* plugin) { delete plugin; }};
  host::LoadedPlugin loaded;
  loaded.manifest.id = "backward";
  loaded.descriptor = &kDescriptor;
  host::SourceStage source(host::Instance::create(loaded, "source"));
  SourceInfo info;
  const Status status = source.info(info);
  CHECK(refuses(status,
                "source (backward), info: the focal lengths of the cameras are -180 and "
                "180 px"));
}
