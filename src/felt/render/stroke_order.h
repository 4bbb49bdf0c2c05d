#pragma once

#include <memory>
#include <vector>

#include "felt/render/scene_stroke.h"

namespace felt {

/// The drawing order of a layer, in blocks. The position of a stroke is found without a search.
/// Adding or removing a stroke in the middle of 10^5 strokes moves only a few hundred of them.
class StrokeOrder {
 public:
  StrokeOrder() = default;
  StrokeOrder(StrokeOrder&&) noexcept = default;
  StrokeOrder& operator=(StrokeOrder&&) noexcept = default;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// Removes the stroke at `index`. Requires index < size().
  void erase(std::size_t index);
  /// Inserts a stroke. Requires index <= size().
  void insert(std::size_t index, SceneStroke& stroke);
  /// Adds a stroke on top.
  void append(SceneStroke& stroke);
  /// Updates SceneStroke::rank. Call it after erase, insert or append. Takes linear time in the
  /// number of blocks and of strokes in changed blocks.
  void number();
  /// Visits all strokes, lowest first.
  template <class Visit>
  void for_each(Visit visit) const {
    for (const auto& block : blocks_) {
      for (SceneStroke* stroke : block->strokes) visit(*stroke);
    }
  }

 private:
  std::vector<std::unique_ptr<OrderBlock>> blocks_;
  std::size_t size_ = 0;
};

}  // namespace felt
