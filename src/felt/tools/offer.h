#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/selection.h"
#include "felt/geometry/point.h"

namespace felt {

/// What a stroke could mean.
enum class OfferKind : std::uint8_t {
  kInk,     ///< the stroke as it was drawn
  kDelete,  ///< deletes the strokes that it covers
  kSelect,  ///< selects the strokes that it encloses
  kLine,    ///< the shape that it resembles
  kArc,
  kCircle,
  kEllipse,
  kTriangle,
  kRectangle,
  kPolygon,
};
/// The names of OfferKind in events and scripts, in order.
inline constexpr std::array<std::string_view, 10> kOfferKinds = {
    "ink",    "delete",  "select",   "line",      "arc",
    "circle", "ellipse", "triangle", "rectangle", "polygon"};

/// One meaning of a stroke, with what it does to the document before that stroke.
struct OfferChoice {
  OfferKind kind = OfferKind::kInk;
  std::size_t count = 0;  ///< number of strokes that it deletes or selects
  Edit edit = {};
  std::optional<Selection> selection = {};  ///< applied after `edit`
};

/// The meanings of a finished stroke. A stroke that may be a gesture is never interpreted silently:
/// one choice applies, and the user can change it until the next change of the drawing (Mankoff,
/// Hudson, Abowd, "Interaction techniques for ambiguity resolution in recognition-based
/// interfaces", DOI 10.1145/354401.354407: an n-best list).
struct Offer {
  Point at;                          ///< where the pen was
  std::vector<OfferChoice> choices;  ///< the most likely one first, kInk last
  std::size_t chosen = 0;            ///< index of the choice that applies
};

/// What is offered, for display.
struct OfferRow {
  OfferKind kind = OfferKind::kInk;
  std::size_t count = 0;  ///< as OfferChoice::count
  friend bool operator==(const OfferRow&, const OfferRow&) noexcept = default;
};
struct OfferView {
  Point at;
  std::vector<OfferRow> rows;
  std::size_t chosen = 0;
  friend bool operator==(const OfferView&, const OfferView&) noexcept = default;
};

}  // namespace felt
