// SPDX-License-Identifier: BSD-3-Clause
#include "scene.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

namespace tolman::town {
namespace {

/// Columns of a 3x4 matrix.
std::array<float, 12> matrixOf(const Placement& p) {
  const float c = p.cosine * p.scale;
  const float s = p.sine * p.scale;
  return {c,
          s,
          0,
          -s,
          c,
          0,
          p.lean_x * p.scale,
          p.lean_y * p.scale,
          p.scale,
          p.position.x,
          p.position.y,
          p.position.z};
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
  attachMesh(fixed_.get(), world.fixed);
  rtcCommitScene(fixed_.get());
  for (Mesh& prototype : world.prototypes) {
    prototype_scenes_.emplace_back(newScene(device_.get()));
    attachMesh(prototype_scenes_.back().get(), prototype);
    rtcCommitScene(prototype_scenes_.back().get());
    prototype_surfaces_.push_back(std::move(prototype.surfaces));
  }
  instances_ = std::move(world.instances);
  for (const MeshInstance& instance : instances_) attachInstance(instance);
  commit();
}

void Scene::check(const char* what) const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("Embree: ") + what + " failed");
}

void Scene::attachMesh(RTCScene scene, const Mesh& mesh) {
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
  rtcSetGeometryTransform(instance_geometries_[index], 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          matrixOf(placement).data());
  rtcCommitGeometry(instance_geometries_[index]);
}

void Scene::change(std::size_t index, std::uint32_t prototype) {
  if (instances_.at(index).prototype == prototype) return;
  instances_[index].prototype = prototype;
  rtcSetGeometryInstancedScene(instance_geometries_[index], prototype_scenes_.at(prototype).get());
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

void Scene::occlude(const int* valid, RTCRay8& rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid, fixed_.get(), &context, &rays);
  rtcOccluded8(valid, placed_.get(), &context, &rays);
}

Scene::Owner Scene::ownerOf(std::uint32_t instance, std::uint32_t primitive) const {
  if (instance == RTC_INVALID_GEOMETRY_ID) return {fixed_surfaces_[primitive], nullptr};
  const MeshInstance& found = instances_[instance];
  return {prototype_surfaces_[found.prototype][primitive], &found};
}

}  // namespace tolman::town
