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

GroundArea boxOf(const Mesh& mesh) {
  GroundArea box = {{1e9F, 1e9F, 1e9F}, {-1e9F, -1e9F, -1e9F}};
  for (const Mesh::Vertex& v : mesh.vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  return box;
}

RTCScene newScene(RTCDevice device) {
  RTCScene scene = rtcNewScene(device);
  // Watertight, so that a ray hits the same triangle with any search structure.
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  return scene;
}

}  // namespace

Scene::Scene(World world) : device_(rtcNewDevice(nullptr)) {
  if (!device_ && rtcGetDeviceError(nullptr) == RTC_ERROR_UNSUPPORTED_CPU) {
    throw std::runtime_error("Embree does not know this processor");
  }
  if (!device_) throw std::bad_alloc();  // or no memory for its threads
  has_packets_of_16_ =
      rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
  fixed_.reset(newScene(device_.get()));
  placed_.reset(newScene(device_.get()));
  surfaces_ = std::move(world.surfaces);
  fixed_surfaces_ = std::move(world.fixed.surfaces);
  lamps_ = StreetLamps(world.lamp_heads);
  town_ = world.area;
  ground_triangles_ = world.ground_triangles;
  fixed_triangles_ = attachMesh(fixed_.get(), world.fixed);
  rtcCommitScene(fixed_.get());
  for (Mesh& prototype : world.prototypes) {
    prototype_scenes_.emplace_back(newScene(device_.get()));
    attachMesh(prototype_scenes_.back().get(), prototype);
    boxes_.push_back(boxOf(prototype));
    rtcCommitScene(prototype_scenes_.back().get());
    prototype_surfaces_.push_back(std::move(prototype.surfaces));
  }
  instances_ = std::move(world.instances);
  has_moved_.resize(instances_.size());
  for (const MeshInstance& instance : instances_) attachInstance(instance);
  commit();
}

void Scene::check(const char* what) {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree: ") + what + " failed");
}

Scene::Triangles Scene::attachMesh(RTCScene scene, const Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                           sizeof(Mesh::Vertex), mesh.vertices.size());
  void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(Mesh::Triangle), mesh.triangles.size());
  check("taking a mesh");
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(Mesh::Vertex));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(Mesh::Triangle));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  triangles_ += mesh.triangles.size();
  return {static_cast<const Mesh::Vertex*>(vertices),
          {static_cast<const Mesh::Triangle*>(triangles), mesh.triangles.size()}};
}

void Scene::attachInstance(const MeshInstance& instance) {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(geometry, prototype_scenes_.at(instance.prototype).get());
  rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          matrixOf(instance.placement).data());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(placed_.get(), geometry);
  rtcReleaseGeometry(geometry);
  instance_geometries_.push_back(geometry);
}

void Scene::move(std::size_t index, const Placement& placement) {
  instances_.at(index).placement = placement;
  has_moved_[index] = true;
  rtcSetGeometryTransform(instance_geometries_[index], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          matrixOf(placement).data());
  rtcCommitGeometry(instance_geometries_[index]);
}

void Scene::show(std::size_t index, bool shown) {
  RTCGeometry geometry = instance_geometries_.at(index);
  shown ? rtcEnableGeometry(geometry) : rtcDisableGeometry(geometry);
}

void Scene::commit() {
  rtcCommitScene(placed_.get());
  check("building the town");
}

void Scene::intersect(const int* valid, RTCRayHit16& rays) const {
  if (has_packets_of_16_) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
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
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, fixed_.get(), &context, &rays);
  rtcIntersect8(valid, placed_.get(), &context, &rays);
}

void Scene::occlude(const int* by_fixed, const int* by_placed, RTCRay8& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const auto wanted = [](const int* valid) {
    return std::any_of(valid, valid + 8, std::identity());
  };
  if (wanted(by_fixed)) rtcOccluded8(by_fixed, fixed_.get(), &context, &rays);
  if (wanted(by_placed)) rtcOccluded8(by_placed, placed_.get(), &context, &rays);
}

void Scene::setSun(const Vec3& to_sun) {
  const bool is_new = to_sun.x != to_sun_.x || to_sun.y != to_sun_.y || to_sun.z != to_sun_.z;
  to_sun_ = to_sun;
  if (is_new) shadows_.start(to_sun, town_);
  if (!shadows_.isOn()) return;
  if (is_new) markFixed(to_sun);
  shadows_.forgetMoving();
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    if (is_new || has_moved_[i]) markInstance(i);
  }
}

/// A ray to the sun first meets a closed surface where that faces away from the sun. So the ground,
/// whose underside no ray sees, only needs to be marked there and where it is about upright.
void Scene::markFixed(const Vec3& to_sun) {
  const auto corner = [&](std::uint32_t i) {
    const Mesh::Vertex& v = fixed_triangles_.vertices[i];
    return Vec3{v.x, v.y, v.z};
  };
  for (std::size_t i = 0; i < fixed_triangles_.triangles.size(); ++i) {
    const auto& [a, b, c] = fixed_triangles_.triangles[i];
    const std::array<Vec3, 3> corners = {corner(a), corner(b), corner(c)};
    Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (normal.z < 0) normal = normal * -1;
    const bool is_level = normal.z > 0.1F * norm(normal);
    const bool faces = is_level && dot(normal, to_sun) > 0.02F * norm(normal);
    if (i >= ground_triangles_ || !faces) shadows_.mark(corners);
  }
}

void Scene::markInstance(std::size_t index) {
  const Placement& p = instances_[index].placement;
  const auto& [low, high] = boxes_[instances_[index].prototype];
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
  if (instance == RTC_INVALID_GEOMETRY_ID) return {fixed_surfaces_[primitive], nullptr};
  const MeshInstance& found = instances_[instance];
  return {prototype_surfaces_[found.prototype][primitive], &found};
}

}  // namespace tolman::town
