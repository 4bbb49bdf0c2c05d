#pragma once

#include <functional>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/profile_builder.h"
#include "felt/tools/smooth/iron_places.h"

namespace felt {

/// Puts stretches of a stroke back together from the points they were ironed to. What lies between
/// is the old stroke: whole segments bit for bit, those at the ends of a stretch cut there. All
/// joints are smooth but for corners that are kept; widths are carried along by the place.
class IronedStroke {
 public:
  /// How far the curve may pass beside the points, mm.
  static constexpr double kCurveMm = 0.01;
  /// Places from joint to joint at most.
  static constexpr int kLongest = 8;

  /// Numbers of joints of the new stroke.
  struct Joints {
    int first, last;
  };
  using PointAt = std::function<Point(int)>;

  IronedStroke(const Stroke& stroke, const ArcMap& map, const IronPlaces& places, PointAt point_at);

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
  /// A segment in the making, up to a place.
  struct Next {
    Cubic curve;
    int end = 0;
  };

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
  [[nodiscard]] JointKind kind_at(int k) const;

  const Stroke& stroke_;
  const ArcMap& map_;
  const IronPlaces& places_;
  PointAt point_at_;
  StrokeData data_;
  ProfileBuilder profile_;
  double u_ = 0.0;  // the old stroke is copied up to here
  Stretch now_;
};

}  // namespace felt
