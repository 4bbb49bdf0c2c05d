#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/material/medium.h"
#include "felt/material/surface_material.h"

namespace felt {

/// Sheets and media by their ids: those that Feltline brings, and a person's own. A value;
/// immutable while anything reads it. The first sheet is paper, the first medium the pencil.
class Materials {
 public:
  /// paper, rough-paper, watercolour, canvas, blackboard, felt, wood, glass; and the media.
  static const Materials& built_in();

  [[nodiscard]] std::span<const SurfaceMaterial> surfaces() const noexcept { return surfaces_; }
  [[nodiscard]] std::span<const Medium> media() const noexcept { return media_; }
  /// By id, or null.
  [[nodiscard]] const SurfaceMaterial* find_surface(std::string_view id) const noexcept;
  [[nodiscard]] const Medium* find_medium(std::string_view id) const noexcept;

  /// Adds one, or replaces the one of that id in its place.
  void put(SurfaceMaterial surface);
  void put(Medium medium);

 private:
  std::vector<SurfaceMaterial> surfaces_;
  std::vector<Medium> media_;
};

// Of Materials::built_in().
std::span<const SurfaceMaterial> surface_materials() noexcept;
std::span<const Medium> media() noexcept;
const SurfaceMaterial* find_surface(std::string_view id) noexcept;
const Medium* find_medium(std::string_view id) noexcept;

/// Friction coefficient of a pair: the medium's own entry for that surface, else
/// mu_medium mu_surface / mu_paper (architecture section 10).
double friction_of(const Medium& medium, const SurfaceMaterial& surface) noexcept;

}  // namespace felt
