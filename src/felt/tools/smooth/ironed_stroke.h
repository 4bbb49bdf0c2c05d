#pragma once

#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/profile_builder.h"
#include "felt/tools/smooth/iron_places.h"

namespace felt {

/// Segments that a stretch of kPlaces places, numbered from a whole multiple of that, was fitted
/// with: kept from preview to preview as long as its points stay the same.
class IronedBlocks {
 public:
  static constexpr int kPlaces = 8;
  struct Segment {
    Cubic curve;
    int end = 0;  ///< its last place
  };
  struct Block {
    std::vector<Segment> segments;
    bool is_good = false;
  };

  explicit IronedBlocks(int places) : blocks_(static_cast<std::size_t>(places / kPlaces + 1)) {}

  [[nodiscard]] Block& at(int place) { return blocks_[static_cast<std::size_t>(place / kPlaces)]; }
  /// The point of a place has changed.
  void forget(int place) { at(place).is_good = false; }

 private:
  std::vector<Block> blocks_;
};

/// Puts stretches of a stroke back together from the points they were ironed to. What lies between
/// is the old stroke: whole segments bit for bit, those at the ends of a stretch cut there. All
/// joints are smooth but for corners that are kept; widths are carried along by the place.
class IronedStroke {
 public:
  /// How far the curve may pass beside the points, mm.
  static constexpr double kCurveMm = 0.01;
  /// Places from joint to joint at most.
  static constexpr int kLongest = IronedBlocks::kPlaces;
  /// kShown: widths are right at joints only.
  enum class Detail { kShown, kExact };

  /// Numbers of joints of the new stroke.
  struct Joints {
    int first, last;
  };
  /// The points that the places were ironed to; those of places that were not are not used.
  struct Ironed {
    std::span<const double> doses;
    std::span<const Point> points;
  };

  IronedStroke(const Stroke& stroke, const ArcMap& map, const IronPlaces& places,
               const Ironed& ironed, IronedBlocks& blocks, Detail detail);

  /// The stretch between two places, in order along the stroke. `turns_seam`: the seam of a closed
  /// stroke is ironed too.
  Joints add(int first, int last, bool turns_seam);
  [[nodiscard]] Result<Stroke> finish() &&;

 private:
  struct Border {
    double u = 0.0;  // on the old stroke
    bool is_joint = false;
    bool turns = false;  // the seam of a closed stroke, ironed too: nothing of the old is left here
    [[nodiscard]] int joint() const { return static_cast<int>(u); }
  };
  /// What is being put together.
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
  std::vector<ProfileBuilder::Match> matches_;  // of the stretch
  std::vector<Next> border_;                    // segments of a block at an end of the stretch
};

}  // namespace felt
