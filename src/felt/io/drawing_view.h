#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/sheet_page.h"
#include "felt/io/layered_sketch.h"
#include "felt/stroke/sketch.h"

namespace felt {

/// A layer of a drawing that is kept elsewhere. Both functions are called on any thread.
struct LayerView {
  std::string_view name{};
  bool visible = true;
  bool locked = false;
  std::size_t count = 0;
  /// Stroke i, the lowest first. Requires i < count.
  std::function<const Stroke&(std::size_t i)> stroke{};
  std::function<std::string(std::size_t i)> id{};
};

/// What LayeredSketch holds, without a copy of it: writers read the strokes where they are. Valid
/// as long as that drawing is, and does not change.
struct DrawingView {
  std::vector<LayerView> layers{};
  std::optional<SheetPage> page{};
  std::string surface{};  ///< where there is no page
  std::vector<std::string> materials{};

  /// Around all ink; empty without any.
  [[nodiscard]] Rect ink() const;
};

/// Returns the part of the page that a picture shows: `page`, or else the ink and `margin_mm`
/// around it, with its edges rounded outwards to 0.01 mm.
Rect picture_area(const Rect& ink, const std::optional<Rect>& page, double margin_mm) noexcept;

DrawingView view_of(const LayeredSketch& drawing);
/// One layer without a name.
DrawingView view_of(const Sketch& sketch);

}  // namespace felt
