#pragma once

#include <span>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// The options of the surface, which do not belong to a tool. In events they are called "sheet.ID":
///   material   a SurfaceMaterial by id
///   color      the colour of new ink: "#rgb", "#rrggbb" or "#rrggbbaa"
class SheetOptions {
 public:
  /// Returns the table of these options. It does not contain the colour, because an OptionSpec
  /// cannot describe the text form of a colour.
  static std::span<const OptionSpec> table();

  /// Sets an option. Fails if the option does not exist, if it does not accept the value, or if the
  /// surface is not known. After a failure nothing has changed.
  Result<void> set(std::string_view id, const OptionValue& value, const Materials& known);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  /// Updates the surface if the material with its id has changed in `known`.
  void follow(const Materials& known);

  [[nodiscard]] const SurfaceMaterial& material() const noexcept { return material_; }
  [[nodiscard]] Rgba color() const noexcept { return color_; }

 private:
  OptionValues values_{table()};
  SurfaceMaterial material_ = surface_materials().front();
  Rgba color_{};
};

}  // namespace felt
