#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/haptics/bricks/guide.h"
#include "felt/haptics/pen_sample.h"
#include "felt/tools/as_needed_gain.h"
#include "felt/tools/guide_line.h"

namespace felt {

/// Follows the pen along a guide, and makes the piece of the path near the pen for the force.
///
/// While the pen touches, the position along the path is searched only near the last one, so that a
/// path that crosses itself does not mislead the pen to another branch. While the pen hovers, and
/// after it has left the guide, the whole path is searched; that takes at most 40,000 points, about
/// 40 us. At an open end, the path continues straight on for 10 mm (Ends::kContinue), so that the
/// guide does not hold the pen at the end; over the first 5 mm of that, its force falls to zero.
///
/// A deterministic function of the samples. Use it on the edit thread. The numbers of holds
/// (GuidePiece::hold) of one session do not overlap: studies begin at 1, GuardRidge at 2^29,
/// Retrace at 2^30 and, for contours, at 3 * 2^29, guides of a drawing at 2^31, EdgeRidges at 3 *
/// 2^30.
class GuideTrack {
 public:
  /// Whether an open path continues straight on at its ends, or ends there.
  enum class Ends { kContinue, kEnd };

  /// Requires check_guide(line). `number` is the first value of GuidePiece::hold; it must be
  /// greater than hold() of an earlier guide of the session.
  GuideTrack(GuideLine line, std::uint32_t number);
  /// Makes a track with a force law that does not follow from the kind of the line.
  GuideTrack(GuideLine line, std::uint32_t number, const GuideLaw& law,
             Ends ends = Ends::kContinue);

  /// Sets the law, from the next sample on.
  void set_law(const GuideLaw& law) noexcept { law_ = law; }
  /// For a law of an edge: sets GuidePiece::free_side, from the next sample on.
  void set_free_side(double side) noexcept { free_side_ = side; }

  void update(const PenSample& sample);

  [[nodiscard]] const GuideLine& line() const noexcept { return line_; }
  /// Returns the force near the last sample. Its points change with every sample.
  [[nodiscard]] const Guide& guide() const noexcept { return guide_; }
  /// Returns the number of this guide, for the id of the force model.
  [[nodiscard]] std::uint32_t number() const noexcept { return number_; }
  [[nodiscard]] std::uint32_t hold() const noexcept { return hold_; }

 private:
  struct Place {
    double mm;           // along the path, from points_[0]
    double distance_mm;  // from the pen
  };

  void resample();
  void measure_teacher();
  void add_ends();
  [[nodiscard]] std::size_t wrapped(std::ptrdiff_t i) const noexcept;
  [[nodiscard]] std::size_t nearest(Point pen, std::ptrdiff_t from, std::ptrdiff_t count) const;
  [[nodiscard]] Place place(Point pen) const;
  [[nodiscard]] double end_share(double place_mm) const noexcept;
  void make_piece(double place_mm);

  GuideLine line_;
  std::vector<Point> points_;  // at equal distances along the path, with the added ends
  std::vector<double> times_;  // of the teacher, s
  std::vector<float> speeds_;  // of the teacher, mm/s
  double spacing_mm_ = GuidePiece::kSpacingMm;
  std::uint32_t number_;
  std::uint32_t hold_;
  GuideLaw law_;
  Ends ends_;
  double free_side_ = 1.0;
  std::size_t at_ = 0;  // nearest point
  bool is_lost_ = true;
  std::int64_t last_ns_ = 0;
  AsNeededGain as_needed_;
  Guide guide_;
};

}  // namespace felt
