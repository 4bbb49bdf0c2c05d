#include "felt/document/body_edit.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace felt {
namespace {

tl::unexpected<Error> wrong_body_edit(const char* what) {
  return fail(ErrorCode::kInvalidArgument, what);
}

bool are_in_range(const std::vector<Vec3>& points) {
  constexpr double kMax = BodyEdit::kMaxCoordinateMm;
  const auto is_within = [](double x) { return x >= -kMax && x <= kMax; };  // false for NaN
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return is_within(p.x) && is_within(p.y) && is_within(p.z);
  });
}

}  // namespace

std::optional<BodyEditKind> body_edit_kind_of(std::string_view name) noexcept {
  const auto* const found = std::find(kBodyEditKindNames.begin(), kBodyEditKindNames.end(), name);
  if (found == kBodyEditKindNames.end()) return std::nullopt;
  return static_cast<BodyEditKind>(found - kBodyEditKindNames.begin());
}

Result<void> check_body_edit(const BodyEdit& edit) {
  if (static_cast<std::size_t>(edit.kind) >= kBodyEditKindNames.size()) {
    return wrong_body_edit("kind: is unknown");
  }
  const bool is_brush = edit.kind == BodyEditKind::kPaint || edit.kind == BodyEditKind::kSmooth;
  const std::size_t path = edit.path_mm.size(), profile = edit.profile_mm.size();
  if (path < (is_brush ? 1U : 2U)) return wrong_body_edit("path: has too few points");
  if (path > BodyEdit::kMaxPoints) return wrong_body_edit("path: has more than 20000 points");
  if (!are_in_range(edit.path_mm)) return wrong_body_edit("path: a point is out of range");
  const bool is_extrusion = edit.kind == BodyEditKind::kExtrude;
  if (is_extrusion && profile < 2) return wrong_body_edit("profile: has too few points");
  if (!is_extrusion && profile > 0) return wrong_body_edit("profile: only an extrusion has one");
  if (profile > BodyEdit::kMaxPoints) return wrong_body_edit("profile: has more than 20000 points");
  if (!are_in_range(edit.profile_mm)) return wrong_body_edit("profile: a point is out of range");
  if (!(std::abs(norm(edit.view) - 1.0) <= BodyEdit::kUnitTolerance)) {
    return wrong_body_edit("view: is not a unit vector");
  }
  if (!(edit.width_mm >= 0.0 && edit.width_mm <= BodyEdit::kMaxWidthMm)) {
    return wrong_body_edit("width_mm: is not a number from 0 to 1000");
  }
  if (!(edit.amount >= 0.0 && edit.amount <= 1.0)) {
    return wrong_body_edit("amount: is not a number from 0 to 1");
  }
  return {};
}

}  // namespace felt
