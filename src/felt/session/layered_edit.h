#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "felt/document/document.h"

namespace felt {

/// Adds further changes of strokes to an edit that fits a document, and computes all positions
/// again. The strokes of the edit keep their order.
///
///   LayeredEdit layered(document, edit);
///   layered.set(partner, mirrored);
///   layered.finish();
class LayeredEdit {
 public:
  /// Requires that the edit fits the document. Both must outlive this object.
  LayeredEdit(const Document& document, Edit& edit);

  /// Returns a stroke as it is after the edit; null if it does not exist then.
  [[nodiscard]] StrokePtr after(StrokeId id) const;
  /// Replaces a stroke of the document, or removes it if `stroke` is null, whatever the edit did
  /// with it before.
  void set(StrokeId id, StrokePtr stroke);
  /// Takes back that the edit adds a stroke.
  void drop(StrokeId id);
  /// Adds a stroke directly above another one, which exists before or after the edit. Returns its
  /// id.
  StrokeId add_above(StrokeId id, StrokePtr stroke);
  /// Adds a symmetry group.
  void add_group(SymmetryGroup group);
  /// Changes or removes (null) a group of the document.
  void set_group(SymmetryId id, SymmetryPtr group);

  /// Writes the changes and the positions to the edit.
  void finish();

 private:
  struct Order {
    LayerId layer;
    std::vector<StrokeId> strokes;  // in their order after the edit; removed ones stay in it
  };

  Order& order_of(LayerId layer);
  StrokeChange& change_of(StrokeId id);

  const Document& document_;
  Edit& edit_;
  std::map<StrokeId, StrokeChange> changes_;
  std::vector<StrokeId> sequence_;  // of the changes
  std::map<LayerId, Order> orders_;
  std::uint64_t next_id_ = 0;
};

}  // namespace felt
