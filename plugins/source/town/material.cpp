// SPDX-License-Identifier: BSD-3-Clause
#include "material.hpp"

namespace tolman::town {

float albedo(const Surface& surface, const SurfaceHit& hit, const StreetPlan& plan) {
  switch (surface.material) {
    case Material::Road:
    case Material::Kerb:
    case Material::Land:
    case Material::Paint:
      return groundAlbedo(surface, hit, plan);
    case Material::Facade:
    case Material::Roof:
      return buildingAlbedo(surface, hit);
    case Material::Leaves:
    case Material::Bark:
      return plantAlbedo(surface, hit);
    case Material::Plain:
    case Material::Wood:
    case Material::Body:
    case Material::Board:
    case Material::Cloth:
      return objectAlbedo(surface, hit);
  }
  return surface.tone;
}

float glassShare(const Surface& surface, const SurfaceHit& hit) {
  if (surface.material == Material::Facade) return windowGlass(surface, hit);
  return surface.material == Material::Body ? carGlass(hit) : 0;
}

}  // namespace tolman::town
