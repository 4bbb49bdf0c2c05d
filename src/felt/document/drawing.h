#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/edit.h"
#include "felt/document/page.h"
#include "felt/document/palette.h"

namespace felt {

/// The part of a drawing that a window shows. A change of the viewport does not count as an unsaved
/// change.
struct Viewport {
  static constexpr double kMaxMm = 1e6;  ///< limit of the coordinates of `center`
  static constexpr double kMinPxPerMm = 1e-4;
  static constexpr double kMaxPxPerMm = 1e5;

  Point center;            ///< mm, shown at the middle of the window
  double px_per_mm = 4.0;  ///< scale, in device-independent pixels
  double angle_deg = 0.0;  ///< clockwise on the screen, -180..180; applied after mirroring
  bool mirrored = false;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Data of a drawing that is only read on request: recordings of how the drawing was made, and
/// content that a newer version of Feltline stored in the file. The .felt format defines these data
/// (FeltExtras). Immutable; copies of a drawing share it.
class DrawingExtras {
 public:
  virtual ~DrawingExtras() = default;
  [[nodiscard]] virtual bool equals(const DrawingExtras& other) const = 0;

 protected:
  DrawingExtras() = default;
  DrawingExtras(const DrawingExtras&) = default;
  DrawingExtras& operator=(const DrawingExtras&) = default;
};

/// A whole drawing, as readers return it and writers accept it. It has no undo history and no
/// selection. A copy shares the strokes and takes linear time in their number.
struct Drawing {
  Document document{};
  Page page{};
  /// False if the drawing was read from a file without a page size. In that case, `page` has the
  /// default size; the other values of `page` are valid.
  bool has_page = true;
  Rgba color{};                    ///< colour of new ink
  LayerId layer{};                 ///< active layer; zero if the user has not chosen one
  Palette palette{};               ///< the drawing's own colours, within PaletteLimits
  std::optional<Viewport> view{};  ///< absent if the drawing was never shown
  /// Texts of the materials that the drawing uses and that are not built in (is_material_text); at
  /// most limits::kMaxMaterialTexts.
  std::vector<std::string> materials{};
  std::shared_ptr<const DrawingExtras> extras{};  ///< may be null

  /// Compares by value, including strokes and extras.
  friend bool operator==(const Drawing& a, const Drawing& b);
};

}  // namespace felt
