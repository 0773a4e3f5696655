// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/input_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "tolman/context.hpp"

namespace tolman::conformance {

namespace {

constexpr std::int64_t kFirstNs = 1'000'000'000;
constexpr std::int64_t kStepNs = 100'000'000;
constexpr int kPlaces = 24;  // view templates per circle

/// Number of steps along the circle before each frame; `turn` steps are one circle.
std::vector<int> stepsUntil(const SequenceOptions& options) {
  std::vector<int> steps(static_cast<std::size_t>(options.frames));
  for (int k = 1; k < options.frames; ++k) {
    const int second = options.stops ? 10 * (k - options.turn) / options.turn : -1;  // tenth of it
    const int step = k < options.turn ? 1 : second == 4 ? 0 : second == 7 ? -1 : 1;
    steps[static_cast<std::size_t>(k)] = steps[static_cast<std::size_t>(k - 1)] + step;
  }
  return steps;
}

Matrix6d covariance(double translation, double rotation) {
  Vector6d diagonal;
  diagonal << Eigen::Vector3d::Constant(translation * translation),
      Eigen::Vector3d::Constant(rotation * rotation);
  return diagonal.asDiagonal();
}

CameraRig rigOf(const SequenceOptions& options) {
  CameraRig rig;
  rig.width = options.width;
  rig.height = options.height;
  rig.calibrated = true;
  rig.pinhole = {0.75 * options.width, 0.75 * options.width, 0.5 * (options.width - 1),
                 0.5 * (options.height - 1)};
  rig.baseline = options.stereo ? 0.3 : 0;
  return rig;
}

/// Moves the camera along the circle and computes valid records of all stages for each frame.
class SequenceGenerator {
 public:
  explicit SequenceGenerator(const SequenceOptions& options)
      : options_(options), steps_(stepsUntil(options)), random_(options.seed), room_(options.seed) {
    sequence_.rig = rigOf(options);
  }

  InputSequence make() {
    for (int k = 0; k < options_.frames; ++k) {
      FrameInput input;
      T_world_camera_ = SyntheticRoom::poseAt(angle(k));
      addImages(k, input.frame);
      addMotion(k, input.motion);
      addPlace(k, input.place);
      addDecision(input.place, input.decision);
      addMap(input);
      input.cells = {{"bump", {8}, std::vector<float>(8, 0.125F)}};
      sequence_.inputs.push_back(std::move(input));
    }
    if (options_.frames > 2) sequence_.last_revisions = {revision(options_.frames - 2)};
    sequence_.graph = graph_;
    return std::move(sequence_);
  }

 private:
  int stepsAt(int k) const { return steps_[static_cast<std::size_t>(k)]; }
  double angle(int k) const { return 2 * std::numbers::pi * stepsAt(k) / options_.turn; }

  template <class R>
  void stamp(int k, R& record) const {
    record.frame = k;
    record.stamp_ns = kFirstNs + k * kStepNs;
  }

  void addImages(int k, Frame& frame) const {
    stamp(k, frame);
    frame.source_index = k;
    frame.has_truth = true;
    frame.T_world_camera_truth = T_world_camera_;
    addSensors(k, frame);
    if (!options_.images) return;
    const CameraRig& rig = sequence_.rig;
    frame.left = room_.view(T_world_camera_, rig, 0);
    if (options_.stereo) {
      frame.right = room_.view(T_world_camera_, rig, rig.baseline);
    }
    if (options_.depth) frame.sensors.push_back(depthImage());
  }

  NamedArray depthImage() const {
    NamedArray depth{"depth.left", {options_.height, options_.width}, {}};
    for (int y = 0; y < options_.height; ++y) {
      for (int x = 0; x < options_.width; ++x) {
        depth.values.push_back(static_cast<float>(
            SyntheticRoom::depth(T_world_camera_, sequence_.rig, Eigen::Vector2d(x, y))));
      }
    }
    return depth;
  }

  /// Sensor arrays with the names that replaying plugins read: planar motion since the previous
  /// frame (m, m, rad), and the frame of the previous circle at the same place.
  void addSensors(int k, Frame& frame) const {
    const PlanarPose before = toPlanar(SyntheticRoom::poseAt(angle(std::max(k - 1, 0))));
    const PlanarPose moved = between(before, toPlanar(T_world_camera_));
    const auto f = [](auto value) { return static_cast<float>(value); };
    frame.sensors.push_back({"motion.planar", {3}, {f(moved.x), f(moved.y), f(moved.theta)}});
    NamedArray candidate{"place.candidate", {0, 4}, {}};
    if (stepsAt(k) >= options_.turn) {
      const auto earlier = std::ranges::find(steps_, stepsAt(k) - options_.turn);
      candidate.shape[0] = 1;
      candidate.values = {f(earlier - steps_.begin()), 0, 0, 0};
    }
    frame.sensors.push_back(std::move(candidate));
  }

  Eigen::Isometry3d step(int k) {
    Vector6d noise;
    for (double& x : noise) x = 0.002 * random_.normal();
    return SyntheticRoom::poseAt(angle(k - 1)).inverse() * SyntheticRoom::poseAt(angle(k)) *
           expSe3(noise);
  }

  void addMotion(int k, Motion& motion) {
    stamp(k, motion);
    if (k == 0) return;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = step(k);
    motion.covariance = covariance(0.01, 0.002);
    setPlanarVelocity(motion, 1e-9 * kStepNs);
    motion.tracked = 100;
    motion.is_keyframe = k % 4 == 0;
    if (options_.images) addDepth(k, motion);
    if (k % 5 == 0) motion.revisions = {revision(k - 1)};
  }

  MotionRevision revision(int k) { return {k, step(k), covariance(0.008, 0.0015)}; }

  void addDepth(int k, Motion& motion) const {
    constexpr int kColumns = 16;
    constexpr int kRows = 6;
    motion.points_frame = k;
    motion.points.resize(4, kColumns * kRows);
    for (int i = 0; i < kColumns * kRows; ++i) {
      const int row = i / kColumns;
      const Eigen::Vector2d pixel((i % kColumns + 0.5) * options_.width / kColumns,
                                  (row + 0.5) * options_.height / kRows);
      const double depth = SyntheticRoom::depth(T_world_camera_, sequence_.rig, pixel);
      motion.points.col(i) << pixel.cast<float>(), static_cast<float>(1 / depth), 1e-4F;
    }
  }

  void addPlace(int k, PlaceObservation& seen) {
    stamp(k, seen);
    const int view = stepsAt(k) * kPlaces / options_.turn;
    const bool novel = view >= made_ && view < kPlaces;
    if (novel) angle_of_template_.push_back(angle(k));
    made_ = static_cast<int>(angle_of_template_.size());
    seen.recognition = novel ? Recognition::Novel : Recognition::Familiar;
    seen.template_id = view % kPlaces;
    const double then = angle_of_template_[static_cast<std::size_t>(seen.template_id)];
    seen.relative_yaw = wrapAngle(angle(k) - then);
    seen.score = novel ? 0 : 0.02 + 0.01 * random_.uniform();
    seen.has_relative_pose = !novel && k % 2 == 0;
    if (!seen.has_relative_pose) return;
    seen.T_template_current = SyntheticRoom::poseAt(then).inverse() * T_world_camera_;
    seen.covariance = covariance(0.05, 0.01);
  }

  void addDecision(const PlaceObservation& seen, Decision& decision) {
    stamp(static_cast<int>(seen.frame), decision);
    decision.experience = decision.template_id = seen.template_id;  // one experience per template
    const bool back = seen.template_id != last_view_;
    last_view_ = seen.template_id;
    decision.action = seen.recognition == Recognition::Novel ? Action::CreateExperience
                      : back                                 ? Action::CloseLoop
                                                             : Action::Stay;
    decision.relative_yaw = seen.relative_yaw;
    decision.has_relative_pose = seen.has_relative_pose;
    decision.T_experience_current = seen.T_template_current;
    decision.covariance = seen.covariance;
    decision.heading = wrapPeriod(angle(static_cast<int>(seen.frame)), 2 * std::numbers::pi);
    decision.confidence = 0.9;
    if (decision.action == Action::CloseLoop && seen_before_.frame >= 0) {
      decision.earlier = {seen_before_};
    }
    seen_before_ = {seen.frame, seen.template_id, seen.T_template_current, seen.covariance};
    if (!seen.has_relative_pose) seen_before_.frame = -1;
  }

  void addMap(FrameInput& input) {
    const Decision& decision = input.decision;
    if (decision.action == Action::CreateExperience) {
      graph_.experiences.push_back(
          {decision.experience, decision.frame, decision.template_id, T_world_camera_});
    }
    if (decision.action != Action::Stay && at_ >= 0) addLink(decision);
    at_ = decision.experience;
    const auto& experience = graph_.experiences[static_cast<std::size_t>(at_)];
    stamp(static_cast<int>(decision.frame), input.map);
    input.map.experience = at_;
    input.map.T_world_camera = T_world_camera_;
    input.map.T_experience_camera = experience.T_world_experience.inverse() * T_world_camera_;
    input.map.version = graph_.version;
    input.map.experiences = static_cast<std::int64_t>(graph_.experiences.size());
    input.map.links = static_cast<std::int64_t>(graph_.links.size());
    input.map.loops = graph_.version;
    if (decision.action != Action::Stay) input.graph = graph_;
  }

  void addLink(const Decision& decision) {
    const bool loop = decision.action == Action::CloseLoop;
    if (loop) ++graph_.version;
    const auto pose = [&](std::int64_t id) {
      return graph_.experiences[static_cast<std::size_t>(id)].T_world_experience;
    };
    Link link{static_cast<std::int64_t>(graph_.links.size()), at_, decision.experience,
              loop ? LinkKind::Loop : LinkKind::Odometry, decision.frame};
    link.T_from_to = pose(at_).inverse() * pose(decision.experience);
    link.covariance = covariance(0.05, 0.01);
    link.duration = loop ? 0 : 1e-9 * kStepNs;
    graph_.links.push_back(link);
  }

  SequenceOptions options_;
  std::vector<int> steps_;
  RandomStream random_;
  SyntheticRoom room_;
  InputSequence sequence_;
  MapGraph graph_;
  Eigen::Isometry3d T_world_camera_ = Eigen::Isometry3d::Identity();
  std::vector<double> angle_of_template_;
  int made_ = 0;
  std::int64_t last_view_ = -1;
  EarlierLoop seen_before_;  ///< by the frame before; frame -1 for none
  std::int64_t at_ = -1;
};

/// Frames 3, 4, 10, 17, 18, 24, ...: single ones and pairs.
bool isChosen(std::size_t index) { return index % 14 == 3 || index % 14 == 4 || index % 14 == 10; }

Image padded(const Image& image) {
  if (image.empty()) return image;
  const auto row_bytes =
      static_cast<std::size_t>(std::ptrdiff_t{image.width()} * bytesPerPixel(image.format()));
  const std::size_t stride = row_bytes + 37;
  const auto rows = static_cast<std::size_t>(image.height());
  const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[stride * rows]);
  std::memset(pixels.get(), 0xee, stride * rows);
  for (int r = 0; r < image.height(); ++r) {
    std::memcpy(pixels.get() + static_cast<std::size_t>(r) * stride, image.row(r), row_bytes);
  }
  return {pixels.get(),   image.width(), image.height(), static_cast<std::ptrdiff_t>(stride),
          image.format(), pixels};
}

Image uniform(int width, int height, int grey) {
  const auto bytes = static_cast<std::size_t>(std::ptrdiff_t{width} * height);
  return Image::create(width, height, PixelFormat::Gray8,
                       [&](std::uint8_t* data) { std::memset(data, grey, bytes); });
}

/// Replaces the answers to one frame by substitutes such as later stages get after a skipped stage.
void replaceSkipped(FrameInput& input, std::int64_t experience) {
  Motion& motion = input.motion;
  motion.state = motion.frame == 0 ? TrackingState::Initialising : TrackingState::Lost;
  motion.covariance *= 100;
  motion.tracked = 0;
  motion.is_keyframe = false;
  motion.points_frame = -1;
  motion.points.resize(4, 0);
  motion.revisions.clear();
  PlaceObservation none;
  none.frame = input.frame.frame;
  none.stamp_ns = input.frame.stamp_ns;
  input.place = none;
  const double heading = input.decision.heading;
  input.decision = Decision();
  input.decision.frame = input.frame.frame;
  input.decision.stamp_ns = input.frame.stamp_ns;
  input.decision.experience = experience;
  input.decision.heading = heading;
  input.decision.confidence = 0;
}

}  // namespace

SequenceOptions optionsFor(Role role, std::uint64_t seed) {
  SequenceOptions options;
  options.seed = seed;
  switch (role) {
    case Role::Source:  // it gives its own frames; only the number of inputs is used
      options.frames = 8;
      options.images = false;
      break;
    case Role::Place:
      options.frames = 40;
      options.turn = 30;
      break;
    case Role::Cells:
    case Role::Map:
      options.frames = 270;  // 75 m: loops to places that were left more than 30 m of path ago
      options.turn = 60;
      options.images = false;
      options.stops = true;
      break;
    default:
      break;
  }
  return options;
}

InputSequence makeSequence(const SequenceOptions& options) {
  return SequenceGenerator(options).make();
}

InputSequence shortened(InputSequence sequence, std::size_t count) {
  if (sequence.inputs.size() > count) sequence.inputs.resize(count);
  sequence.last_revisions.clear();
  return sequence;
}

void removeImages(InputSequence& sequence) {
  std::vector<FrameInput>& inputs = sequence.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isChosen(i) && i + 2 < inputs.size()) continue;
    inputs[i].frame.left = inputs[i].frame.right = Image();
    inputs[i].frame.defect = "the file is damaged";
  }
}

void loseTracking(InputSequence& sequence) {
  std::int64_t experience = -1;
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    FrameInput& input = sequence.inputs[i];
    const bool makes_experience = input.decision.action == Action::CreateExperience;
    const bool makes_template = input.place.recognition == Recognition::Novel;
    const bool stays = input.decision.action == Action::Stay;
    if (stays &&
        input.decision.experience != experience) {  // the frame with its loop closure was skipped
      input.decision.action = Action::CloseLoop;
    }
    if (isChosen(i) && !makes_experience && !makes_template) {
      replaceSkipped(input, experience);
    } else if (isChosen(i)) {
      input.motion.state = TrackingState::Lost;
      input.motion.covariance *= 100;
    }
    experience = input.decision.experience;
  }
}

void dropFrames(InputSequence& sequence) {
  std::vector<FrameInput> kept;
  Eigen::Isometry3d T_dropped = Eigen::Isometry3d::Identity();
  double dt = 0;
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    FrameInput& input = sequence.inputs[i];
    T_dropped = T_dropped * input.motion.T_previous_current;
    dt += input.motion.dt;
    const bool needed = input.decision.action == Action::CreateExperience ||
                        input.place.recognition == Recognition::Novel;
    if (isChosen(i) && !needed) continue;
    input.motion.T_previous_current = T_dropped;
    input.motion.revisions.clear();  // they may refer to frames that were left out
    input.decision.earlier.clear();
    setPlanarVelocity(input.motion, dt);
    T_dropped.setIdentity();
    dt = 0;
    kept.push_back(std::move(input));
  }
  sequence.inputs = std::move(kept);
  sequence.last_revisions.clear();
}

void padRows(InputSequence& sequence) {
  for (FrameInput& input : sequence.inputs) {
    input.frame.left = padded(input.frame.left);
    input.frame.right = padded(input.frame.right);
  }
}

void makeTextureless(InputSequence& sequence) {
  const CameraRig& rig = sequence.rig;
  for (FrameInput& input : sequence.inputs) {
    for (Image* image : {&input.frame.left, &input.frame.right}) {
      const int grey = input.frame.frame % 2 == 0 ? 0 : 255;
      if (!image->empty()) *image = uniform(rig.width, rig.height, grey);
    }
  }
}

namespace {

const Eigen::Vector3d kHalf(6.5, 1.8, 5.5);  // m; half of the sides, all different

/// The first pose is kRadius to the right of the centre.
Eigen::Isometry3d inRoom(const Eigen::Isometry3d& T_world_camera) {
  return Eigen::Translation3d(SyntheticRoom::kRadius, 0, 0) * T_world_camera;
}

double lattice(std::uint64_t key) {
  key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<double>((key ^ (key >> 31U)) >> 11U) * 0x1.0p-53;
}

}  // namespace

Eigen::Isometry3d SyntheticRoom::poseAt(double angle) {
  return fromPlanar({kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), angle});
}

SyntheticRoom::Hit SyntheticRoom::castRay(const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& ray) {
  Hit hit{0, origin, 1e9};
  for (int axis = 0; axis < 3; ++axis) {
    if (ray[axis] == 0) continue;
    const double side = ray[axis] > 0 ? kHalf[axis] : -kHalf[axis];
    const double distance = (side - origin[axis]) / ray[axis];
    if (distance >= hit.distance) continue;
    hit.distance = distance;
    hit.wall = 2 * axis + (ray[axis] > 0 ? 1 : 0);
  }
  hit.point = origin + hit.distance * ray;
  return hit;
}

double SyntheticRoom::noise(std::uint64_t wall, double u, double v) const {
  const double u0 = std::floor(u);
  const double v0 = std::floor(v);
  const double a = u - u0;
  const double b = v - v0;
  const auto corner = [&](double du, double dv) {
    const auto iu = static_cast<std::uint64_t>(static_cast<std::int64_t>(u0 + du) + 4096);
    const auto iv = static_cast<std::uint64_t>(static_cast<std::int64_t>(v0 + dv) + 4096);
    return lattice(seed_ * 0x9e3779b97f4a7c15ULL + (wall << 32U) + (iu << 16U) + iv);
  };
  const double top = corner(0, 0) * (1 - a) + corner(1, 0) * a;
  const double bottom = corner(0, 1) * (1 - a) + corner(1, 1) * a;
  return top * (1 - b) + bottom * b;
}

double SyntheticRoom::greyLevel(const Hit& hit) const {
  const int axis = hit.wall / 2;
  const double u = hit.point[(axis + 1) % 3];
  const double v = hit.point[(axis + 2) % 3];
  const auto wall = static_cast<std::uint64_t>(hit.wall);
  const double coarse = noise(wall, 1.5 * u, 1.5 * v);
  const double fine = noise(wall + 8, 7 * u, 7 * v);
  return 20 + 130 * coarse + 90 * fine;
}

Image SyntheticRoom::view(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                          double offset) const {
  const Eigen::Isometry3d T = inRoom(T_world_camera);
  const Eigen::Vector3d origin = T * Eigen::Vector3d(offset, 0, 0);
  return Image::create(rig.width, rig.height, PixelFormat::Gray8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < rig.height; ++y) {
      for (int x = 0; x < rig.width; ++x) {
        const Eigen::Vector3d ray = T.linear() * rig.pinhole.ray(Eigen::Vector2d(x, y));
        *pixel++ = static_cast<std::uint8_t>(greyLevel(castRay(origin, ray)));
      }
    }
  });
}

double SyntheticRoom::depth(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                            const Eigen::Vector2d& pixel) {
  const Eigen::Isometry3d T = inRoom(T_world_camera);
  return castRay(T.translation(), T.linear() * rig.pinhole.ray(pixel)).distance;
}

}  // namespace tolman::conformance
