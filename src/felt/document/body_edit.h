#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/vec3.h"

namespace felt {

/// The kinds of edits of a body (BodyEdit).
enum class BodyEditKind : std::uint8_t {
  kCut,      ///< cuts the body along `path_mm`, and removes the part on one side
  kExtrude,  ///< pulls the part of the surface inside the closed `path_mm` out along `profile_mm`
  kPaint,    ///< draws `path_mm` onto the surface: `width_mm`, `color`
  kSmooth,   ///< smooths the surface along `path_mm`: `width_mm`, `amount`
};

/// An edit of the solid that a drawing inflates to (felt/solid). A drawing applies its edits in the
/// order of their ids. Immutable, like a stroke.
///
/// Points are in the frame of a solid: mm, x right, y up, z towards the viewer. Its origin is the
/// origin of the page, so that it does not depend on the body. (A solid is drawn from the page at
/// z = 0, so a point (x, y) of the page is (x, -y, 0).)
struct BodyEdit {
  static constexpr std::size_t kMaxPoints = 20'000;  ///< of `path_mm` and of `profile_mm`
  static constexpr double kMaxCoordinateMm = 1e6;
  static constexpr double kMaxWidthMm = 1000.0;
  static constexpr double kUnitTolerance = 1e-6;  ///< of the length of `view`

  BodyEditKind kind = BodyEditKind::kCut;
  std::vector<Vec3> path_mm = {};     ///< the stroke, as drawn
  std::vector<Vec3> profile_mm = {};  ///< the second stroke of kExtrude
  /// The direction in which the strokes were drawn, from the eye to the body: a unit vector.
  Vec3 view{0.0, 0.0, -1.0};
  double width_mm = 2.0;  ///< 0..kMaxWidthMm
  Rgba color = {0, 0, 0, 255};
  double amount = 0.5;  ///< 0..1

  friend bool operator==(const BodyEdit&, const BodyEdit&) = default;
};

/// Largest number of edits of the body of a drawing.
inline constexpr std::size_t kMaxBodyEdits = 1000;

/// The names of the kinds in files, in the order of the enum.
inline constexpr std::array<std::string_view, 4> kBodyEditKindNames = {"cut", "extrude", "paint",
                                                                       "smooth"};
[[nodiscard]] constexpr std::string_view body_edit_kind_name(BodyEditKind kind) noexcept {
  return kBodyEditKindNames[static_cast<std::size_t>(kind)];
}
/// Returns the kind with this name, or nullopt if there is none.
[[nodiscard]] std::optional<BodyEditKind> body_edit_kind_of(std::string_view name) noexcept;

/// Checks the invariants: every number is finite and within the limits above; a path has 2 to
/// kMaxPoints points, or 1 if it paints or smooths; and kExtrude has a profile of 2 to kMaxPoints
/// points, while the other kinds have none. All readers call this. The message starts with the key
/// of the event (docs/formats/events.md).
Result<void> check_body_edit(const BodyEdit& edit);

}  // namespace felt
