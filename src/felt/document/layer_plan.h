#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/layer_table.h"
#include "felt/document/reorder.h"

namespace felt {

/// The layers after an edit. prepare() finds every error before anything changes.
class LayerPlan {
 public:
  /// Both must outlive this object.
  LayerPlan(const LayerTable& table, std::span<const LayerChange> changes)
      : table_(table), changes_(changes) {}

  /// Computes the new order. Fails if a layer is not as it was before a change, if an index is
  /// beyond the end or used twice, if no layer would be left, or if the layers of a group would not
  /// be neighbours with equal groups. Requires that the ids of the changes are different.
  Result<void> prepare();
  /// Returns true if the layer exists after the edit.
  [[nodiscard]] bool is_kept(LayerId id) const;
  /// Changes the table, which is the one that was passed to the constructor. Requires that
  /// prepare() succeeded.
  void carry_out(LayerTable& table) const;

 private:
  struct Run {
    std::size_t first = 0, last = 0;  // of placed_; `last` is not included
  };

  [[nodiscard]] Result<void> check_layer(const LayerChange& change) const;
  [[nodiscard]] Result<void> check_groups() const;
  [[nodiscard]] Result<void> check_run(Run run, std::set<GroupId>& apart) const;
  [[nodiscard]] LayerGroupPtr unchanged_group(std::size_t index) const;

  const LayerTable& table_;
  std::span<const LayerChange> changes_;
  std::map<LayerId, const LayerChange*> by_id_;
  std::vector<const LayerChange*> placed_;  // that exist after the edit, the lowest first
  Reordered<LayerId> order_;
  bool moves_ = false;  // the order changes
};

}  // namespace felt
