#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/render/image.h"

namespace felt {

/// Where the tip of a medium has been, in pixels: the middle of a dab, and the tone there, 0..1.
struct TipAt {
  Vec center_px;
  double radius_px = 0.0;
  double tone = 1.0;
};

/// How hard each pixel of a line was pushed on (Grain: q), how far it lies from the middle (rho)
/// and where across the line, for the looks of media. One thread; keeps its buffer.
///
/// Each strip between two dabs writes what it pushed: tone (1 - 0.45 rho^2) at rho radii from its
/// middle line, falling to kLeastPush within the soft edge of a medium. Where a line crosses itself
/// the harder one stays, hence the order does not matter, nor which part of a picture is asked for.
class PressureMap {
 public:
  static constexpr double kLeastPush = -1.0 / 3.0;  ///< nothing of the sheet is reached
  static constexpr int kRows = 128;                 ///< steps of push
  static constexpr int kAcross = 512;               ///< places across a line

  /// Of nothing yet, for the pixels of `area`; `edge`: MediumLook::edge.
  void begin(PixelRect area, double edge);
  /// Where the tip went, dab to dab in straight lines. `into`, `out`: the directions, of length 1,
  /// in which it came there and goes on, of a ring; without them the way begins and ends in a cap.
  void lay(std::span<const TipAt> way, Vec into = {}, Vec out = {});

  [[nodiscard]] PixelRect area() const noexcept { return area_; }
  /// From pixel area().x0 on.
  [[nodiscard]] const std::int32_t* row(int y) const noexcept {
    return values_.data() + static_cast<std::size_t>(y - area_.y0) * stride_;
  }
  /// kLeastPush..1 for a pixel of the area; kLeastPush where the tip has not been.
  [[nodiscard]] double push_at(int x, int y) const noexcept;

  // What a value of a row says: 12 bits of push above 10 of rho^2 above 9 of the place across, so
  // that the larger number is the harder push.
  static constexpr int kRimShift = 9, kPushShift = 19;
  static std::size_t row_of(std::int32_t value) noexcept {
    return static_cast<std::size_t>(value >> (kPushShift + 5));
  }
  static std::size_t rim_of(std::int32_t value) noexcept {  ///< 64 steps of rho^2
    return static_cast<std::size_t>((value >> (kRimShift + 4)) & 63);
  }
  static std::size_t across_of(std::int32_t value) noexcept {
    return static_cast<std::size_t>(value & (kAcross - 1));
  }
  /// The push in the middle of a step.
  static double push_of_row(int row) noexcept {
    return kLeastPush + (1.0 - kLeastPush) * (row + 0.5) / kRows;
  }

 private:
  struct Strip;
  void lay(const Strip& strip);
  void lay_in_pieces(const Strip& strip);

  PixelRect area_;
  float edge_from_ = 2.0F;  // rho^2 where the soft edge begins
  std::size_t stride_ = 0;
  std::vector<std::int32_t> values_;
  std::vector<TipAt> way_;
};

}  // namespace felt
