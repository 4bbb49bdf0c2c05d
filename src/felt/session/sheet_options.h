#pragma once

#include <span>
#include <string_view>

#include "felt/haptics/material.h"
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

  /// Error: no such option, or a value that it does not take; nothing changes then.
  Result<void> set(std::string_view id, const OptionValue& value);
  [[nodiscard]] Result<OptionValue> get(std::string_view id) const;

  [[nodiscard]] const SurfaceMaterial& material() const noexcept;
  [[nodiscard]] Rgba color() const noexcept { return color_; }

 private:
  OptionValues values_{table()};
  Rgba color_{};
};

}  // namespace felt
