// SPDX-License-Identifier: BSD-3-Clause
#include "camera_rigs.hpp"

#include <algorithm>
#include <cctype>

#include "camera_calibration.hpp"

namespace tolman::ros_messages {

bool isPair(const std::string& left, const std::string& right) {
  if (const auto at = left.find("left"); at != std::string::npos) {
    for (auto from = at; from != std::string::npos; from = left.find("left", from + 1)) {
      std::string other = left;
      if (other.replace(from, 4, "right") == right) return true;
    }
  }
  if (left.size() != right.size()) return false;
  const auto [a, b] = std::mismatch(left.begin(), left.end(), right.begin());
  if (a == left.end() || std::isdigit(static_cast<unsigned char>(*a)) == 0) return false;
  return *b == *a + 1 && *b <= '9' && std::equal(a + 1, left.end(), b + 1);
}

std::optional<CameraNames> chooseCameraNames(const std::vector<std::string>& cameras,
                                             const CameraNames& named, bool mono) {
  CameraNames chosen = named;
  if (named.left.empty() && named.right.empty() && cameras.size() == 1) chosen.left = cameras[0];
  std::vector<CameraNames> pairs;
  for (const std::string& left : cameras) {
    for (const std::string& right : cameras) {
      const bool fits = (chosen.left.empty() || chosen.left == left) &&
                        (chosen.right.empty() || chosen.right == right);
      if (fits && isPair(left, right)) pairs.push_back({left, right});
    }
  }
  const bool complete = !chosen.left.empty() && (!chosen.right.empty() || mono || pairs.empty());
  if (!complete && pairs.size() != 1) return std::nullopt;
  if (!complete) chosen = pairs.front();
  if (mono) chosen.right.clear();
  return chosen;
}

std::string infoBeside(const std::string& images) {
  const std::string folder = untransported(images);
  return folder.substr(0, folder.rfind('/')) + "/camera_info";
}

namespace {

Status setGiven(const CameraParameters& p, bool pair, CameraRig& rig) {
  const Result<CameraRig> given = p.rig(rig.width, rig.height);
  if (!given.isOk()) return given.status();
  rig = given.value();
  if (!pair) rig.baseline = 0;
  if (!pair || p.baseline > 0) return Status::ok();
  return Status::invalidParameter("pinhole is given for two cameras without baseline; give both");
}

Result<CameraInfos> readInfos(const CameraTopic& left, const CameraTopic* right) {
  const auto of_left = readCameraInfo(*left.info);
  if (!of_left) {
    return Status::invalidInput(left.info_name +
                                ": is no complete CameraInfo; give pinhole of rectified images");
  }
  CameraInfos infos{*of_left, std::nullopt, left.info_name};
  if (right == nullptr) return infos;
  infos.right_name = right->info_name;
  infos.right = readCameraInfo(*right->info);
  if (infos.right) return infos;
  return Status::invalidInput(right->info_name +
                              ": is no complete CameraInfo; give pinhole and baseline");
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
  if (p.baseline > 0 && !p.isGiven()) {
    return Status::invalidParameter("baseline is given without pinhole; give both");
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
        "; set left_info and right_info, give pinhole and baseline, or set mono: true");
  }
  if (!status.isOk()) return status;
  return rigs;
}

}  // namespace tolman::ros_messages
