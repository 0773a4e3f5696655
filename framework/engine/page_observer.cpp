// SPDX-License-Identifier: BSD-3-Clause
#include "engine/page_observer.hpp"

#include <fmt/ranges.h>

#include <set>

namespace tolman::run {

host::OrRefusal<std::string> findPageObserver(const host::Catalogue& catalogue,
                                              const std::string& wanted) {
  std::set<std::string> ids;
  for (const host::Manifest& manifest : catalogue.manifests()) {
    if (manifest.role == Role::Observer && manifest.hasExtra("page")) ids.insert(manifest.id);
  }
  if (!wanted.empty()) {
    const auto found = catalogue.find(wanted, Role::Observer);
    if (const auto* refusal = std::get_if<host::Refusal>(&found)) return *refusal;
    if (ids.contains(wanted)) return wanted;
  } else if (!ids.empty()) {
    return *ids.begin();
  }
  return host::Refusal{"plugin/no-page",
                       wanted.empty() ? "no observer on the search path serves a page"
                                      : "observer '" + wanted + "' serves no page",
                       ids.empty() ? "name the folder of such an observer with --plugin-path"
                                   : fmt::format("observers that do: {}", fmt::join(ids, ", "))};
}

}  // namespace tolman::run
