// SPDX-License-Identifier: BSD-3-Clause
// Ray intersection with the geometry of the town, by Embree 3.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "light.hpp"
#include "shadow_grid.hpp"
#include "world.hpp"

namespace tolman::town {

/// Rays are traced in packets of this many.
inline constexpr int kRaysPerPacket = 16;
/// Instead of the index of an instance: fixed geometry, or the sky.
inline constexpr std::uint32_t kNoInstance = RTC_INVALID_GEOMETRY_ID;

class Scene {
 public:
  /// Builds the search structures. Throws std::runtime_error if Embree fails, std::bad_alloc for
  /// lack of memory.
  explicit Scene(World world);

  /// First hit of each ray with valid[i] == -1; directions need not be unit vectors.
  void intersect(const int* valid, RTCRayHit16& rays) const;
  void intersect(const int* valid, RTCRayHit8& rays) const;
  /// Sets tfar to -infinity for rays that fixed geometry blocks, of those with by_fixed[i] == -1,
  /// and for those that instances block, of those with by_placed[i] == -1. By eight, because
  /// rtcOccluded16 of Embree 3.13.5 does not return for some coherent rays.
  void occlude(const int* by_fixed, const int* by_placed, RTCRay8& rays) const;
  /// Where to look for what blocks rays to the sun.
  const ShadowGrid& shadows() const { return shadows_; }
  /// Sets the direction of the sun of the next pictures, after commit().
  void setSun(const Vec3& to_sun);

  struct Owner {
    const Surface* surface;
    std::uint32_t number;          ///< of the surface
    const MeshInstance* instance;  ///< null for fixed geometry
  };
  Owner ownerOf(std::uint32_t instance, std::uint32_t primitive) const;
  const Surface& surface(std::uint32_t number) const { return world_.surfaces[number]; }

  const StreetLamps& lamps() const { return lamps_; }
  /// Instances are shown until hidden.
  void show(std::size_t index, bool shown);
  /// Moves instance `index`. This and show() take effect at commit().
  void move(std::size_t index, const Placement& placement);
  void commit();
  std::size_t triangles() const { return triangles_; }

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  using Device = std::unique_ptr<RTCDeviceTy, Release>;
  using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;

  /// A new scene, with the mesh if one is given; its buffers stay those of the mesh.
  SceneHandle sceneOf(Mesh* mesh);
  void check(const char* what);
  void markFixed(const Vec3& to_sun);
  void markInstance(std::size_t index);

  World world_;
  StreetLamps lamps_;
  Device device_;
  bool has_packets_of_16_;  ///< the processor has instructions for them
  // Two scenes, because a commit builds the whole search structure of its scene anew: a car that
  // moves must not rebuild that of all streets and houses.
  SceneHandle fixed_;   // the fixed mesh
  SceneHandle placed_;  // the instances; instance i is geometry i
  std::vector<SceneHandle> prototypes_;
  std::vector<RTCGeometry> geometries_;  // of instances; owned by placed_
  std::vector<GroundArea> boxes_;        ///< around the prototypes
  std::vector<bool> has_moved_;          ///< instances that are not where they were at first
  std::size_t triangles_ = 0;
  ShadowGrid shadows_;
  Vec3 to_sun_ = {0, 0, 0};
};

}  // namespace tolman::town
