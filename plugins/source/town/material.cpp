// SPDX-License-Identifier: BSD-3-Clause
#include "material.hpp"

namespace tolman::town {

void albedos(const Surface& surface, const SurfaceHits& hits, const StreetPlan& plan,
             Eight& result) {
  switch (surface.material) {
    case Material::Road:
    case Material::Kerb:
    case Material::Land:
    case Material::Paint:
      return groundAlbedos(surface, hits, plan, result);
    case Material::Facade:
    case Material::Roof:
      return buildingAlbedos(surface, hits, result);
    case Material::Leaves:
    case Material::Bark:
      return plantAlbedos(surface, hits, result);
    case Material::Plain:
    case Material::Wood:
    case Material::Body:
    case Material::Board:
    case Material::Cloth:
      return objectAlbedos(surface, hits, result);
  }
}

void glassShares(const Surface& surface, const SurfaceHits& hits, Eight& result) {
  if (surface.material == Material::Facade) return windowGlass(surface, hits, result);
  if (surface.material == Material::Body) return carGlass(hits, result);
  result = Eight{};
}

}  // namespace tolman::town
