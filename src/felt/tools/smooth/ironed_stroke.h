#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/profile_builder.h"
#include "felt/tools/smooth/iron_places.h"

namespace felt {

/// Cache of the segments fitted to blocks of kPlaces places. A block is reused from preview to
/// preview while its points stay the same.
class IronedBlocks {
 public:
  static constexpr int kPlaces = 8;
  struct Segment {
    Cubic curve;
    int end = 0;  ///< last place of the segment
  };
  struct Block {
    std::vector<Segment> segments;
    bool is_good = false;
  };

  explicit IronedBlocks(int places) : blocks_(static_cast<std::size_t>(places / kPlaces + 1)) {}

  [[nodiscard]] Block& at(int place) { return blocks_[static_cast<std::size_t>(place / kPlaces)]; }
  /// Invalidates the block of a place whose point has changed.
  void forget(int place) { at(place).is_good = false; }

 private:
  std::vector<Block> blocks_;
};

/// Builds a stroke from the ironed points of some stretches and, between the stretches, from the
/// old stroke: whole segments are copied bit for bit, segments at the ends of a stretch are cut.
/// All joints are smooth except kept corners. Each place keeps its width.
class IronedStroke {
 public:
  /// Maximum distance of the curve from the ironed points, mm.
  static constexpr double kCurveMm = 0.01;
  /// Maximum number of places per segment.
  static constexpr int kLongest = IronedBlocks::kPlaces;
  /// With kShown, widths are exact only at joints.
  enum class Detail { kShown, kExact };

  /// Joint numbers in the new stroke.
  struct Joints {
    int first, last;
  };
  /// The ironed points, by place; points of places with dose 0 are not used.
  struct Ironed {
    std::span<const double> doses;
    std::span<const Point> points;
  };

  IronedStroke(const Stroke& stroke, const ArcMap& map, const IronPlaces& places,
               const Ironed& ironed, IronedBlocks& blocks, Detail detail);

  /// Adds the ironed stretch between two places. Add the stretches in order along the stroke.
  /// `turns_seam` says that the seam of a closed stroke is ironed, too.
  Joints add(int first, int last, bool turns_seam);
  [[nodiscard]] Result<Stroke> finish() &&;

 private:
  struct Border {
    double u = 0.0;  // parameter on the old stroke
    bool is_joint = false;
    bool turns = false;  // at the ironed seam of a closed stroke: no old ink remains here
    [[nodiscard]] int joint() const { return static_cast<int>(u); }
  };
  /// The stretch being built.
  struct Stretch {
    int first = 0, last = 0;
    Border from, to;
  };
  using Next = IronedBlocks::Segment;

  [[nodiscard]] Border border(int k) const;
  void copy_up_to(double u);
  void push(const Cubic& c, JointKind end);
  [[nodiscard]] int count() const { return static_cast<int>(data_.points.size() / 3); }
  [[nodiscard]] Point point(int k) const;
  [[nodiscard]] bool goes_on(const Border& border, bool has_more) const;
  [[nodiscard]] Vec direction(int k, int side) const;
  [[nodiscard]] Vec ironed_direction(int k, int side) const;
  bool try_segment(int from, int to, Vec start, Cubic& c) const;
  [[nodiscard]] Next next_segment(int from, Vec start) const;
  [[nodiscard]] std::span<const Next> block(int from);
  void add_segment(int from, const Next& next);
  [[nodiscard]] JointKind kind_at(int k) const;

  const Stroke& stroke_;
  const ArcMap& map_;
  const IronPlaces& places_;
  Ironed ironed_;
  IronedBlocks& blocks_;
  Detail detail_;
  StrokeData data_;
  ProfileBuilder profile_;
  double u_ = 0.0;  // the old stroke is copied up to here
  Stretch now_;
  std::vector<ProfileBuilder::Match> matches_;  // old and new parameters in the stretch
  std::vector<Next> border_;                    // segments of a block at an end of the stretch
};

}  // namespace felt
