// SPDX-License-Identifier: BSD-3-Clause
#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>

namespace tolman::town {
namespace {

/// Columns of a 3x4 matrix.
std::array<float, 12> matrixOf(const Placement& p) {
  const float c = p.cosine * p.scale;
  const float s = p.sine * p.scale;
  return {c, s, 0, -s, c, 0, 0, 0, p.scale, p.position.x, p.position.y, p.position.z};
}

// Both are rows of one number of each ray.
constexpr std::size_t kRow8 = 8 * sizeof(float);
constexpr std::size_t kRows = sizeof(RTCRayHit8) / kRow8;
static_assert(sizeof(RTCRayHit16) == 2 * kRows * kRow8);

void copyHalf(const RTCRayHit16& from, std::size_t half, RTCRayHit8& to) {
  const auto* source = reinterpret_cast<const std::byte*>(&from) + half * kRow8;
  auto* target = reinterpret_cast<std::byte*>(&to);
  for (std::size_t i = 0; i < kRows; ++i) {
    std::memcpy(target + i * kRow8, source + 2 * i * kRow8, kRow8);
  }
}

void copyHalf(const RTCRayHit8& from, std::size_t half, RTCRayHit16& to) {
  const auto* source = reinterpret_cast<const std::byte*>(&from);
  auto* target = reinterpret_cast<std::byte*>(&to) + half * kRow8;
  for (std::size_t i = 0; i < kRows; ++i) {
    std::memcpy(target + 2 * i * kRow8, source + i * kRow8, kRow8);
  }
}

RTCIntersectContext coherent() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

GroundArea boxOf(const Mesh& mesh) {
  GroundArea box = {{1e9F, 1e9F, 1e9F}, {-1e9F, -1e9F, -1e9F}};
  for (const Vec3& v : mesh.vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  return box;
}

}  // namespace

Scene::Scene(World world)
    : world_(std::move(world)), lamps_(world_.lamp_heads), device_(rtcNewDevice(nullptr)) {
  if (!device_ && rtcGetDeviceError(nullptr) == RTC_ERROR_UNSUPPORTED_CPU) {
    throw std::runtime_error("Embree does not know this processor");
  }
  if (!device_) throw std::bad_alloc();  // or no memory for its threads
  has_packets_of_16_ =
      rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  fixed_ = sceneOf(&world_.fixed);
  placed_ = sceneOf(nullptr);
  for (Mesh& prototype : world_.prototypes) {
    boxes_.push_back(boxOf(prototype));
    prototypes_.push_back(sceneOf(&prototype));
  }
  has_moved_.resize(world_.instances.size());
  for (const MeshInstance& instance : world_.instances) {
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, prototypes_.at(instance.prototype).get());
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                            matrixOf(instance.placement).data());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(placed_.get(), geometry);
    rtcReleaseGeometry(geometry);
    geometries_.push_back(geometry);
  }
  commit();
}

void Scene::check(const char* what) {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree: ") + what + " failed");
}

Scene::SceneHandle Scene::sceneOf(Mesh* mesh) {
  SceneHandle scene(rtcNewScene(device_.get()));
  // Watertight, so that a ray hits the same triangle with any search structure.
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  if (mesh == nullptr) return scene;
  const std::size_t vertices = mesh->vertices.size();
  mesh->vertices.emplace_back();  // Embree reads 16 bytes of each
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh->vertices.data(), 0, sizeof(Mesh::Vertex), vertices);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh->triangles.data(), 0, sizeof(Mesh::Triangle),
                             mesh->triangles.size());
  check("taking a mesh");
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  triangles_ += mesh->triangles.size();
  return scene;
}

void Scene::move(std::size_t index, const Placement& placement) {
  world_.instances.at(index).placement = placement;
  has_moved_[index] = true;
  rtcSetGeometryTransform(geometries_[index], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          matrixOf(placement).data());
  rtcCommitGeometry(geometries_[index]);
}

void Scene::show(std::size_t index, bool shown) {
  (shown ? rtcEnableGeometry : rtcDisableGeometry)(geometries_.at(index));
}

void Scene::commit() {
  rtcCommitScene(placed_.get());
  check("building the town");
}

void Scene::intersect(const int* valid, RTCRayHit16& rays) const {
  if (has_packets_of_16_) {
    RTCIntersectContext context = coherent();
    rtcIntersect16(valid, fixed_.get(), &context, &rays);
    rtcIntersect16(valid, placed_.get(), &context, &rays);
    return;
  }
  for (std::size_t half = 0; half < 2; ++half) {
    RTCRayHit8 rays8;
    copyHalf(rays, half, rays8);
    intersect(valid + 8 * half, rays8);
    copyHalf(rays8, half, rays);
  }
}

void Scene::intersect(const int* valid, RTCRayHit8& rays) const {
  RTCIntersectContext context = coherent();
  rtcIntersect8(valid, fixed_.get(), &context, &rays);
  rtcIntersect8(valid, placed_.get(), &context, &rays);
}

void Scene::occlude(const int* by_fixed, const int* by_placed, RTCRay8& rays) const {
  RTCIntersectContext context = coherent();
  const auto wanted = [](const int* valid) {
    return std::any_of(valid, valid + 8, std::identity());
  };
  if (wanted(by_fixed)) rtcOccluded8(by_fixed, fixed_.get(), &context, &rays);
  if (wanted(by_placed)) rtcOccluded8(by_placed, placed_.get(), &context, &rays);
}

void Scene::setSun(const Vec3& to_sun) {
  const bool is_new = to_sun.x != to_sun_.x || to_sun.y != to_sun_.y || to_sun.z != to_sun_.z;
  to_sun_ = to_sun;
  if (is_new) shadows_.start(to_sun, world_.area);
  if (!shadows_.isOn()) return;
  if (is_new) markFixed(to_sun);
  shadows_.forgetMoving();
  for (std::size_t i = 0; i < world_.instances.size(); ++i) {
    if (is_new || has_moved_[i]) markInstance(i);
  }
}

/// A ray to the sun first meets a closed surface where that faces away from the sun. So the ground,
/// whose underside no ray sees, only needs to be marked there and where it is about upright.
void Scene::markFixed(const Vec3& to_sun) {
  for (std::size_t i = 0; i < world_.fixed.triangles.size(); ++i) {
    const std::array<Vec3, 3> corners = world_.fixed.corners(i);
    Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (normal.z < 0) normal = normal * -1;
    const bool is_level = normal.z > 0.1F * norm(normal);
    const bool faces = is_level && dot(normal, to_sun) > 0.02F * norm(normal);
    if (i >= world_.ground_triangles || !faces) shadows_.mark(corners);
  }
}

void Scene::markInstance(std::size_t index) {
  const Placement& p = world_.instances[index].placement;
  const auto& [low, high] = boxes_[world_.instances[index].prototype];
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 own = Vec3{(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                          (i & 4U) != 0 ? high.z : low.z} *
                     p.scale;
    corners[i] = p.rotate(own) + p.position;
  }
  shadows_.mark(corners, has_moved_[index]);
}

Scene::Owner Scene::ownerOf(std::uint32_t instance, std::uint32_t primitive) const {
  const bool is_fixed = instance == RTC_INVALID_GEOMETRY_ID;
  const MeshInstance* found = is_fixed ? nullptr : &world_.instances[instance];
  const Mesh& mesh = is_fixed ? world_.fixed : world_.prototypes[found->prototype];
  const std::uint32_t number = mesh.surfaces[primitive];
  return {&world_.surfaces[number], number, found};
}

}  // namespace tolman::town
