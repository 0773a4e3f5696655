// SPDX-License-Identifier: BSD-3-Clause
#include "camera_rigs.hpp"

#include "camera_calibration.hpp"

namespace tolman::ros_messages {
namespace {

Status setGiven(const CameraParameters& p, bool pair, CameraRig& rig) {
  rig.calibrated = true;
  rig.pinhole = p.pinhole(rig.width, rig.height);
  rig.baseline = pair ? p.baseline : 0;
  const bool inside = rig.pinhole.cx < rig.width && rig.pinhole.cy < rig.height;
  if (!inside) return Status::invalidParameter("cx, cy is outside of the image; correct it");
  if (!pair || p.baseline > 0) return Status::ok();
  return Status::invalidParameter("fx is given for two cameras without baseline; give both");
}

Result<CameraInfos> readInfos(const CameraTopic& left, const CameraTopic* right) {
  const auto of_left = readCameraInfo(*left.info);
  if (!of_left) {
    return Status::invalidInput(left.info_name +
                                ": is no complete CameraInfo; give fx of rectified images");
  }
  CameraInfos infos{*of_left, std::nullopt, left.info_name};
  if (right == nullptr) return infos;
  infos.right_name = right->info_name;
  infos.right = readCameraInfo(*right->info);
  if (infos.right) return infos;
  return Status::invalidInput(right->info_name +
                              ": is no complete CameraInfo; give fx and baseline");
}

Status setFromInfos(const CameraTopic& left, const CameraTopic* right, ImageSize size,
                    CameraRigs& rigs) {
  const Result<CameraInfos> infos = readInfos(left, right);
  if (!infos.isOk()) return infos.status();
  const bool rectified = isRectified(left.images, infos.value());
  rigs.findings.push_back(
      {Finding::Severity::Note, left.images,
       rectified ? "is taken as rectified" : "is raw, and rectified by D, R, P"});
  if (hasWrongSign(infos.value())) {
    rigs.findings.push_back({Finding::Severity::Warning, right->info_name,
                             "has a positive P[3], as of a camera to the left of the left one; its "
                             "size is used as the baseline",
                             "correct its sign; if the images are exchanged, the run says so",
                             Finding::Kind::Contradiction});
  }
  if (rectified) {
    const Result<CameraRig> rig = rectifiedRig(infos.value(), size.width, size.height);
    if (rig.isOk()) rigs.rectified = rig.value();
    return rig.status();
  }
  const Result<RawRig> raw = rawRig(infos.value(), size.width, size.height);
  if (raw.isOk()) rigs.raw = raw.value();
  return raw.status();
}

}  // namespace

Status checkCombination(const CameraParameters& p) {
  if (p.mono && !p.right.empty()) {
    return Status::invalidParameter("mono and right are both given; keep one");
  }
  if (p.baseline > 0 && p.fx == 0) {
    return Status::invalidParameter("baseline is given without fx; give both");
  }
  return Status::ok();
}

Result<CameraRigs> makeRigs(const CameraParameters& parameters, ImageSize size,
                            const CameraTopic& left, const CameraTopic* right) {
  CameraRigs rigs;
  rigs.rectified.width = size.width;
  rigs.rectified.height = size.height;
  Status status;
  if (parameters.isGiven()) {
    status = setGiven(parameters, right != nullptr, rigs.rectified);
  } else if (left.info && (right == nullptr || right->info)) {
    status = setFromInfos(left, right, size, rigs);
  } else if (right != nullptr) {
    status = Status::invalidInput(
        "there is no CameraInfo beside " + left.images + " and " + right->images +
        "; set left_info and right_info, give fx and baseline, or set mono: true");
  }
  if (!status.isOk()) return status;
  return rigs;
}

}  // namespace tolman::ros_messages
