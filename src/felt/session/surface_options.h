#pragma once

#include <span>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The options of the surface, which do not belong to a tool. The only option is `material`, the id
/// of a SurfaceMaterial; in events it is called "surface.material".
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

 private:
  OptionValues values_{table()};
  SurfaceMaterial material_ = surface_materials().front();
};

}  // namespace felt
