#include "felt/document/layer_table.h"

#include <algorithm>
#include <iterator>

namespace felt {

LayerTable::LayerTable(Layer first) {
  layers_.push_back(std::move(first));
  number_from(0);
}

std::size_t LayerTable::index_of(LayerId id) const noexcept {
  const auto found = indices_.find(id.value);
  return found == indices_.end() ? layers_.size() : found->second;
}

const Layer* LayerTable::find(LayerId id) const noexcept {
  const std::size_t index = index_of(id);
  return index < layers_.size() ? &layers_[index] : nullptr;
}

Layer* LayerTable::find(LayerId id) noexcept {
  const std::size_t index = index_of(id);
  return index < layers_.size() ? &layers_[index] : nullptr;
}

void LayerTable::rearrange(std::span<const Move> moves) {
  std::vector<std::size_t> gone;
  std::vector<std::pair<std::size_t, Layer>> placed;
  std::size_t lowest = layers_.size();
  for (const Move& m : moves) {
    if (m.from) {
      gone.push_back(*m.from);
      lowest = std::min(lowest, *m.from);
    }
    if (m.to) {
      placed.emplace_back(*m.to, m.from ? std::move(layers_[*m.from])
                                        : Layer{.id = m.id, .name = {}, .strokes = {}});
      lowest = std::min(lowest, *m.to);
    } else {
      indices_.erase(m.id.value);
    }
  }
  std::sort(gone.begin(), gone.end());
  std::sort(placed.begin(), placed.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  const std::size_t size = layers_.size() - gone.size() + placed.size();
  std::vector<Layer> tail;
  tail.reserve(size - lowest);
  auto next_gone = gone.begin();
  auto next_placed = placed.begin();
  std::size_t next = lowest;
  for (std::size_t i = lowest; i < size; ++i) {
    if (next_placed != placed.end() && next_placed->first == i) {
      tail.push_back(std::move((next_placed++)->second));
      continue;
    }
    for (; next_gone != gone.end() && *next_gone == next; ++next_gone) ++next;
    tail.push_back(std::move(layers_[next++]));
  }
  layers_.erase(layers_.begin() + static_cast<std::ptrdiff_t>(lowest), layers_.end());
  layers_.insert(layers_.end(), std::make_move_iterator(tail.begin()),
                 std::make_move_iterator(tail.end()));
  number_from(lowest);
}

void LayerTable::number_from(std::size_t index) {
  moved_ += layers_.size() - index;
  ids_.resize(index);
  for (std::size_t i = index; i < layers_.size(); ++i) {
    ids_.push_back(layers_[i].id);
    indices_[layers_[i].id.value] = i;
  }
}

}  // namespace felt
