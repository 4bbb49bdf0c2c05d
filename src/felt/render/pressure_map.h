#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/render/image.h"
#include "felt/render/tip_strips.h"

namespace felt {

/// Stores, for each pixel of a line, the push (Grain: q), the distance from the middle (rho) and
/// the position across the line, from which InkShade computes the look of a medium. Reuses its
/// buffer. Not thread-safe.
///
/// In the strip between two dabs, the push at rho radii from the middle line is tone * (1 - 0.45
/// rho^2). Within the soft edge of a medium, the push falls to kMinPush. If a line crosses itself,
/// the larger push is kept (VisitMap keeps all of them). So the result depends neither on the order
/// of the strips nor on which part of a picture is drawn.
class PressureMap {
 public:
  static constexpr double kMinPush = -1.0 / 3.0;  ///< the ink reaches no part of the relief
  static constexpr int kRows = 128;               ///< steps of push
  static constexpr int kAcross = 512;             ///< steps across a line

  /// Starts an empty map for the pixels of `area`. `edge` is MediumLook::edge.
  void begin(PixelRect area, double edge);
  /// Adds the path of the tip, with straight lines from dab to dab. If the path is a part of a
  /// closed stroke, `into` and `out` are the directions, of length 1, in which the tip arrives at
  /// the path and leaves it. Without them the path begins and ends with a cap.
  void lay(std::span<const TipAt> way, Vec into = {}, Vec out = {});

  [[nodiscard]] PixelRect area() const noexcept { return area_; }
  /// Returns the values of row y, starting at area().x0.
  [[nodiscard]] const std::int32_t* row(int y) const noexcept {
    return values_.data() + static_cast<std::size_t>(y - area_.y0) * stride_;
  }
  /// Returns the push at a pixel of the area, kMinPush..1; kMinPush if the tip did not touch the
  /// pixel.
  [[nodiscard]] double push_at(int x, int y) const noexcept;

  /// Returns the strips that were laid, in the order of the paths.
  [[nodiscard]] std::span<const TipStrip> strips() const noexcept { return strips_; }
  [[nodiscard]] float edge_from() const noexcept { return edge_from_; }

  // A value consists of 12 bits of push, 10 bits of rho^2 and 9 bits of the position across, from
  // the highest to the lowest, so that a larger push gives a larger value.
  static constexpr int kRimShift = 9, kPushShift = 19;
  static constexpr float kMaxKey = 4095.0F, kMaxRim = 1023.0F, kMaxAcross = 511.0F;
  static std::size_t row_of(std::int32_t value) noexcept {
    return static_cast<std::size_t>(value >> (kPushShift + 5));
  }
  static std::size_t rim_of(std::int32_t value) noexcept {  ///< 64 steps of rho^2
    return static_cast<std::size_t>((value >> (kRimShift + 4)) & 63);
  }
  static std::size_t across_of(std::int32_t value) noexcept {
    return static_cast<std::size_t>(value & (kAcross - 1));
  }
  /// Returns the push in the middle of a step.
  static double push_of_row(int row) noexcept {
    return kMinPush + (1.0 - kMinPush) * (row + 0.5) / kRows;
  }

 private:
  PixelRect area_;
  float edge_from_ = 2.0F;  // value of rho^2 at which the soft edge begins
  std::size_t stride_ = 0;
  std::vector<std::int32_t> values_;
  std::vector<TipStrip> strips_;
};

}  // namespace felt
