#pragma once

#include <span>
#include <string_view>

#include "felt/haptics/force_law.h"
#include "felt/material/materials.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The options of the surface, which do not belong to a tool; in events they are called
/// "surface.material", the id of a SurfaceMaterial, "surface.plane_only" and "surface.law".
class SurfaceOptions {
 public:
  static std::span<const OptionSpec> table();

  /// Sets an option. Fails if the option does not exist, if it does not accept the value, or if the
  /// surface is not known. After a failure nothing has changed.
  Result<void> set(std::string_view id, const OptionValue& value, const Materials& known);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  /// Updates the surface if the material with its id has changed in `known`.
  void follow(const Materials& known);

  [[nodiscard]] const SurfaceMaterial& material() const noexcept { return material_; }
  /// True: the plane of the surface is the only force, whatever the tool.
  [[nodiscard]] bool plane_only() const noexcept { return values_.is_on(1); }
  /// The form of the forces of tools.
  [[nodiscard]] LawForm law() const noexcept { return static_cast<LawForm>(values_.choice(2)); }

 private:
  OptionValues values_{table()};
  SurfaceMaterial material_ = surface_materials().front();
};

}  // namespace felt
