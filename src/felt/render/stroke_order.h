#pragma once

#include <memory>
#include <vector>

#include "felt/render/scene_stroke.h"

namespace felt {

/// The drawing order of a layer, in blocks: a stroke knows its place without a search, and one that
/// comes or goes in the middle of 10^5 moves some hundred others, not all of them.
class StrokeOrder {
 public:
  StrokeOrder() = default;
  StrokeOrder(StrokeOrder&&) noexcept = default;
  StrokeOrder& operator=(StrokeOrder&&) noexcept = default;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  /// Takes the stroke out that stands at `index`. Requires index < size().
  void erase(std::size_t index);
  /// Requires index <= size().
  void insert(std::size_t index, SceneStroke& stroke);
  /// On top of all.
  void append(SceneStroke& stroke);
  /// Brings SceneStroke::rank up to date after any of the above: linear in what changed and in the
  /// blocks.
  void number();
  /// All of them, the lowest first.
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
