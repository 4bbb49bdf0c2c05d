#pragma once

#include <compare>
#include <cstdint>

namespace felt {

/// A typed number that names a stroke, layer, fill, guide, symmetry group, group of layers or
/// edit of the body of a document. The id zero names nothing. Ids are never reused within a
/// document, except those of groups of layers, so an id in an undo step always means the same
/// object.
template <class Tag>
struct Id {
  std::uint64_t value = 0;

  /// Returns true if the id is not zero.
  [[nodiscard]] constexpr explicit operator bool() const noexcept { return value != 0; }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;
};

using StrokeId = Id<struct StrokeTag>;
using LayerId = Id<struct LayerTag>;
using FillId = Id<struct FillTag>;
using GuideId = Id<struct GuideTag>;
using SymmetryId = Id<struct SymmetryTag>;
using GroupId = Id<struct GroupTag>;
using BodyEditId = Id<struct BodyEditTag>;

}  // namespace felt
