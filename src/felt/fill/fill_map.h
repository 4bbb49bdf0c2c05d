#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/fill.h"
#include "felt/fill/planar_map.h"

namespace felt {

/// A fill, and the bridges that close gaps of its boundary, so that a window can show them.
struct FoundFill {
  Fill fill;
  std::vector<TipLink> bridges;
};

/// The areas that strokes enclose. Updates take time in proportion to the change and, as soon as
/// the next question is asked, to the number of pieces of all strokes. Not thread-safe.
class FillMap {
 public:
  /// The largest number of cubics of the boundary of a fill.
  static constexpr std::size_t kMaxCubics = 100'000;
  /// The largest gap that a message names, in mm.
  static constexpr double kMaxNamedGapMm = 32.0;

  /// Adds, replaces and removes strokes; see LineMeetings::update.
  void update(std::span<const FillLine> changes);

  /// Returns the fill of the smallest bounded face that contains p, if gaps of up to `max_gap_mm`
  /// are closed by bridges. Fails with kInvalidArgument if p or the size is not a number in range,
  /// or p is on a line; with kNotFound if the area is open: the message says where its gap is, if
  /// closing gaps up to kMaxNamedGapMm would close the area; with kLimitExceeded if the boundary
  /// has more than kMaxCubics cubics.
  Result<FoundFill> face_at(Point p, double max_gap_mm, Rgba color);

  /// Returns the widest gap that would have to be closed for face_at() to find an area at p, or
  /// nullopt if there is none up to kMaxNamedGapMm.
  std::optional<TipLink> find_gap(Point p, double max_gap_mm);

  /// Returns the strokes and their meetings.
  [[nodiscard]] const LineMeetings& meetings() const noexcept { return meetings_; }
  /// Returns the links for this size of gaps. The reference is valid until the next update. Much
  /// faster than map().
  const std::vector<TipLink>& links(double max_gap_mm);
  /// Returns the planar map for this size of gaps. The reference is valid until the next update.
  const PlanarMap& map(double max_gap_mm);
  /// Returns the fill of the face inside a loop of map(max_gap_mm).
  FoundFill fill_of(std::size_t loop, double max_gap_mm, Rgba color);

 private:
  struct MapOfGap {
    explicit MapOfGap(TipLinks known) : tips(std::move(known)) {}
    TipLinks tips;
    std::optional<std::vector<TipLink>> links;  // none after an update
    std::unique_ptr<PlanarMap> map;             // null after an update
  };

  LineMeetings meetings_;
  std::map<double, MapOfGap> maps_;
};

}  // namespace felt
