#pragma once

#include <compare>
#include <cstdint>

namespace felt {

/// A typed number that names a thing of a document. Zero names nothing. Ids are never reused
/// within a document, so an id in an undo step still means the same thing later.
template <class Tag>
struct Id {
  std::uint64_t value = 0;

  /// True when the id names something.
  [[nodiscard]] constexpr explicit operator bool() const noexcept { return value != 0; }
  friend constexpr auto operator<=>(Id, Id) noexcept = default;
};

using StrokeId = Id<struct StrokeTag>;
using LayerId = Id<struct LayerTag>;

}  // namespace felt
