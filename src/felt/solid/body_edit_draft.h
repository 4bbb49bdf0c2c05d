#pragma once
#include <cstdint>
#include <vector>
#include "felt/geometry/vec3.h"
#include "felt/stroke/stroke.h"
namespace felt {
enum class BodyEditKind : std::uint8_t { kCut, kExtrude, kPaint, kSmooth };
struct BodyEdit {
  BodyEditKind kind = BodyEditKind::kCut;
  std::vector<Vec3> path_mm;
  std::vector<Vec3> profile_mm;
  Vec3 view{0, 0, -1};
  double width_mm = 1.0;
  Rgba color{};
  double amount = 1.0;
};
}
