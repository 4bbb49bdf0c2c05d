#pragma once

#include <span>
#include <string_view>

#include "felt/material/materials.h"
#include "felt/stroke/stroke.h"
#include "felt/tools/tool_options.h"

namespace felt {

/// What is chosen for the sheet rather than for a tool, as "sheet.ID" in events:
///   material   what it is made of: a SurfaceMaterial by id
///   color      of new ink: "#rgb", "#rrggbb" or "#rrggbbaa"
class SheetOptions {
 public:
  /// The rows that a table can describe: all but the colour, which is any text of that form.
  static std::span<const OptionSpec> table();

  /// Error: no such option, a value that it does not take, a sheet that is not among these; nothing
  /// changes then.
  Result<void> set(std::string_view id, const OptionValue& value, const Materials& known);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  /// The sheet in use has become another one of the same id.
  void follow(const Materials& known);

  [[nodiscard]] const SurfaceMaterial& material() const noexcept { return material_; }
  [[nodiscard]] Rgba color() const noexcept { return color_; }

 private:
  OptionValues values_{table()};
  SurfaceMaterial material_ = surface_materials().front();
  Rgba color_{};
};

}  // namespace felt
