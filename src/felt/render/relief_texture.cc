#include "felt/render/relief_texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "felt/render/relief_square.h"

namespace felt {
namespace {

constexpr int kFraction = 40;  // bits of a texel: so many that rounding is never visible

/// Rotation and scale: x -> (a x - b y, b x + a y) + shift, in tiles.
struct Turning {
  int a = 1, b = 0;
  double shift_x = 0.0, shift_y = 0.0;
};
struct Tooth {
  Turning finer, finest;
  double share = 0.0;
};

/// A weave gets a weak tooth, because a weave repeated at smaller scales is a pattern that no cloth
/// has.
Tooth tooth_of(HeightCharacter character) noexcept {
  const Turning finer{4, 2, 0.3125, 0.0625}, finest{7, -4, 0.5625, 0.8125};
  if (character == HeightCharacter::kWood) {
    return {{4, 0, 0.3125, 0.0625}, {9, 0, 0.5625, 0.8125}, 0.75};
  }
  return {finer, finest, character == HeightCharacter::kWeave ? 0.3 : 0.75};
}

ReliefSquare base_of(const HeightField& field) {
  ReliefSquare base{512, std::vector<float>(std::size_t{512} * 512)};
  const double step = field.tile_mm() / base.side;
  const double per_rms = 1.0 / (1e-3 * field.spec().rms_um);
  for (int y = 0; y < base.side; ++y) {
    for (int x = 0; x < base.side; ++x) {
      base.heights[static_cast<std::size_t>(y) * 512 + static_cast<std::size_t>(x)] =
          static_cast<float>(per_rms * field.at({step * x, step * y}).height_mm);
    }
  }
  return base;
}

/// Doubles the resolution. A new height is interpolated by a cubic through the four nearest
/// heights. This is accurate, because a wavelength contains at least 13 heights.
ReliefSquare doubled(const ReliefSquare& from) {
  const int side = 2 * from.side;
  ReliefSquare wide{
      side, std::vector<float>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side))};
  const auto between = [](float a, float b, float c, float d) {
    return 0.5625F * (b + c) - 0.0625F * (a + d);
  };
  const auto place = [&](int x, int y) -> float& {
    return wide.heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(side) +
                        static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < from.side; ++y) {
    for (int x = 0; x < from.side; ++x) {
      place(2 * x, 2 * y) = from.at(x, y);
      place(2 * x + 1, 2 * y) =
          between(from.at(x - 1, y), from.at(x, y), from.at(x + 1, y), from.at(x + 2, y));
    }
  }
  for (int y = 1; y < side; y += 2) {
    for (int x = 0; x < side; ++x) {
      place(x, y) =
          between(wide.at(x, y - 3), wide.at(x, y - 1), wide.at(x, y + 1), wide.at(x, y + 3));
    }
  }
  return wide;
}

ReliefSquare with_tooth(const ReliefSquare& base, HeightCharacter character) {
  const Tooth tooth = tooth_of(character);
  const auto share = static_cast<float>(tooth.share);
  const auto norm = static_cast<float>(1.0 / std::sqrt(1.0 + 2.0 * tooth.share * tooth.share));
  ReliefSquare seen{base.side, std::vector<float>(base.heights.size())};
  const auto turned = [&](const Turning& t, int x, int y) {
    return base.at(t.a * x - t.b * y + static_cast<int>(t.shift_x * base.side),
                   t.b * x + t.a * y + static_cast<int>(t.shift_y * base.side));
  };
  std::size_t i = 0;
  for (int y = 0; y < base.side; ++y) {
    for (int x = 0; x < base.side; ++x, ++i) {
      seen.heights[i] = norm * (base.heights[i] +
                                share * (turned(tooth.finer, x, y) + turned(tooth.finest, x, y)));
    }
  }
  return seen;
}

std::uint64_t fixed(double texels) noexcept {
  const double scale = static_cast<double>(std::uint64_t{1} << kFraction);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(texels * scale + 0.5)));
}

}  // namespace

ReliefSquare halved(const ReliefSquare& from) {
  const int side = from.side / 2;
  ReliefSquare half{side, {}};
  half.heights.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      half.heights.push_back(0.25F * (from.at(2 * x, 2 * y) + from.at(2 * x + 1, 2 * y) +
                                      from.at(2 * x, 2 * y + 1) + from.at(2 * x + 1, 2 * y + 1)));
    }
  }
  return half;
}

std::shared_ptr<const ReliefLevel> level_of(const ReliefSquare& square) {
  auto level = std::make_shared<ReliefLevel>();
  while ((1 << level->log2_side) < square.side) ++level->log2_side;
  level->texels.reserve(square.heights.size());
  double squares = 0.0;
  for (const float h : square.heights) {
    squares += static_cast<double>(h) * static_cast<double>(h);
    const double texel = std::floor(ReliefLevel::kPerRms * static_cast<double>(h) + 0.5);
    level->texels.push_back(static_cast<std::int8_t>(std::clamp(texel, -127.0, 127.0)));
  }
  level->kept = std::min(1.0, squares / static_cast<double>(square.heights.size()));
  return level;
}

double seen_relief(const HeightField& field, Point place) noexcept {
  if (!(field.spec().rms_um > 0.0)) return 0.0;
  const Tooth tooth = tooth_of(field.spec().character);
  const auto turned = [&](const Turning& t) {
    const Point p{t.a * place.x - t.b * place.y + t.shift_x * field.tile_mm(),
                  t.b * place.x + t.a * place.y + t.shift_y * field.tile_mm()};
    return field.at(p).height_mm;
  };
  const double h =
      field.at(place).height_mm + tooth.share * (turned(tooth.finer) + turned(tooth.finest));
  return h / (1e-3 * field.spec().rms_um * std::sqrt(1.0 + 2.0 * tooth.share * tooth.share));
}

std::shared_ptr<const ReliefLevel> ReliefTexture::level(double px_per_wavelength) {
  if (field_ == nullptr || !(field_->spec().rms_um > 0.0)) return nullptr;
  const double px_per_tile = HeightField::kWavesPerTile * px_per_wavelength;
  int log2 = kCoarsest;
  while (log2 < kFinest && 0.75 * (1 << log2) < px_per_tile) ++log2;
  if (!(px_per_tile > (1 << kCoarsest))) return nullptr;
  const std::lock_guard lock(mutex_);
  auto& known = levels_[static_cast<std::size_t>(log2)];
  if (known) return known;
  ReliefSquare base = doubled(base_of(*field_));
  if (log2 == kFinest) {
    known = level_of(with_tooth(doubled(base), field_->spec().character));
    return known;
  }
  ReliefSquare seen = with_tooth(base, field_->spec().character);
  for (int n = kUsual; n >= kCoarsest; --n) {
    levels_[static_cast<std::size_t>(n)] = level_of(seen);
    seen = halved(seen);
  }
  return known;
}

ReliefPlane::ReliefPlane(const ReliefLevel& level, double tile_mm, const View& view, Vec turn)
    : texels_(level.texels.data()), log2_side_(level.log2_side) {
  const double side = 1 << level.log2_side;
  const double per_mm = side / tile_mm;
  is_between_ = per_mm < view.px_per_mm / 0.75;
  const auto turned = [&](Vec px) {
    const Point p = view.to_mm(px);
    return Vec{turn.x * p.x + turn.y * p.y, turn.x * p.y - turn.y * p.x};
  };
  const Vec corner = turned({0.5, 0.5});
  const Vec right = turned({1.5, 0.5}) - corner, down = turned({0.5, 1.5}) - corner;
  // The shift keeps pixels off the edges of texels when a pixel is a whole number of texels. For
  // interpolation, the height of a texel is the height at its corner.
  const double shift = is_between_ ? 0.0 : 0.3717;
  u0_ = fixed(std::fmod(per_mm * corner.x + shift, side));
  v0_ = fixed(std::fmod(per_mm * corner.y + shift, side));
  ux_ = fixed(std::fmod(per_mm * right.x, side));
  vx_ = fixed(std::fmod(per_mm * right.y, side));
  uy_ = fixed(std::fmod(per_mm * down.x, side));
  vy_ = fixed(std::fmod(per_mm * down.y, side));
}

void ReliefPlane::add_row(int x, int y, int count, int weight, int* sums) const noexcept {
  const auto across = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
  const auto downwards = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
  std::uint64_t u = u0_ + across * ux_ + downwards * uy_;
  std::uint64_t v = v0_ + across * vx_ + downwards * vy_;
  const std::uint64_t mask = (std::uint64_t{1} << log2_side_) - 1;
  if (!is_between_) {
    for (int i = 0; i < count; ++i, u += ux_, v += vx_) {
      const std::uint64_t row = ((v >> kFraction) & mask) << log2_side_;
      sums[i] += weight * texels_[row + ((u >> kFraction) & mask)];
    }
    return;
  }
  for (int i = 0; i < count; ++i, u += ux_, v += vx_) {
    const std::uint64_t c0 = (u >> kFraction) & mask, c1 = (c0 + 1) & mask;
    const std::uint64_t r0 = (v >> kFraction) & mask, r1 = (r0 + 1) & mask;
    const auto fx = static_cast<int>((u >> (kFraction - 8)) & 255U);
    const auto fy = static_cast<int>((v >> (kFraction - 8)) & 255U);
    const auto at = [&](std::uint64_t r, std::uint64_t c) {
      return int{texels_[(r << log2_side_) + c]};
    };
    const int top = at(r0, c0) * (256 - fx) + at(r0, c1) * fx;
    const int bottom = at(r1, c0) * (256 - fx) + at(r1, c1) * fx;
    sums[i] += (weight * ((top * (256 - fy) + bottom * fy) / 256)) / 256;
  }
}

}  // namespace felt
