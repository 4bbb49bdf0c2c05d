#include "felt/render/stroke_order.h"

#include <algorithm>

namespace felt {
namespace {

std::ptrdiff_t signed_of(std::size_t i) noexcept {
  return static_cast<std::ptrdiff_t>(i);
}

}  // namespace

void StrokeOrder::erase(std::size_t index) {
  auto block = blocks_.begin();
  while (index >= (*block)->strokes.size()) index -= (*block++)->strokes.size();
  auto& strokes = (*block)->strokes;
  strokes.erase(strokes.begin() + signed_of(index));
  (*block)->is_numbered = false;
  if (strokes.empty()) blocks_.erase(block);
  --size_;
}

void StrokeOrder::insert(std::size_t index, SceneStroke& stroke) {
  if (index == size_) return append(stroke);
  auto block = blocks_.begin();
  while (index > (*block)->strokes.size()) index -= (*block++)->strokes.size();
  auto& strokes = (*block)->strokes;
  strokes.insert(strokes.begin() + signed_of(index), &stroke);
  (*block)->is_numbered = false;
  ++size_;
  if (strokes.size() <= OrderBlock::kMax) return;
  auto upper = std::make_unique<OrderBlock>();
  const auto middle = strokes.begin() + signed_of(strokes.size() / 2);
  upper->strokes.assign(middle, strokes.end());
  strokes.erase(middle, strokes.end());
  blocks_.insert(block + 1, std::move(upper));
}

void StrokeOrder::append(SceneStroke& stroke) {
  if (blocks_.empty() || blocks_.back()->strokes.size() >= OrderBlock::kMax) {
    blocks_.push_back(std::make_unique<OrderBlock>());
    blocks_.back()->first = size_;
    blocks_.back()->is_numbered = true;
  }
  OrderBlock& block = *blocks_.back();
  stroke.block = &block;
  stroke.slot = block.strokes.size();
  block.strokes.push_back(&stroke);
  ++size_;
}

void StrokeOrder::number() {
  std::size_t first = 0;
  for (const auto& block : blocks_) {
    block->first = first;
    first += block->strokes.size();
    if (block->is_numbered) continue;
    for (std::size_t i = 0; i < block->strokes.size(); ++i) {
      block->strokes[i]->block = block.get();
      block->strokes[i]->slot = i;
    }
    block->is_numbered = true;
  }
}

}  // namespace felt
