#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// The new order of a list from index `from` on. The elements below `from` keep their positions.
template <class Id>
struct Reordered {
  std::size_t from = 0;
  std::vector<Id> tail;
  std::size_t size = 0;  ///< size of the whole list afterwards

  void apply_to(std::vector<Id>& list) const {
    if (from == list.size() && tail.empty()) return;
    list.resize(from);
    list.insert(list.end(), tail.begin(), tail.end());
  }
};

/// Elements that are removed from and added to a list, by absolute index: removed elements have
/// their index before the change, added elements their index after it. The other elements keep
/// their order and fill the gaps.
template <class Id>
class Moves {
 public:
  void remove(std::size_t index_before) { removed_.push_back(index_before); }
  void add(std::size_t index_after, Id id) { added_.push_back({index_after, id}); }
  /// Keeps the element at the same index before and after.
  void keep(std::size_t index, Id id) { kept_.push_back({index, id}); }

  /// Returns the new order. Requires that the indices that were passed to remove() are in the list
  /// and unique. Fails if an index that was passed to add() is beyond the end or used twice. Takes
  /// linear time in the number of elements from the lowest move on.
  template <class T>
  Result<Reordered<Id>> reorder(std::span<const T> old) {
    if (removed_.empty() && added_.empty()) {
      return Reordered<Id>{old.size(), {}, old.size()};  // replaced in place
    }
    for (const Placed& k : kept_) {
      removed_.push_back(k.index);
      added_.push_back(k);
    }
    std::sort(removed_.begin(), removed_.end());
    std::sort(added_.begin(), added_.end(),
              [](const Placed& a, const Placed& b) { return a.index < b.index; });
    const std::size_t size = old.size() - removed_.size() + added_.size();
    for (std::size_t i = 0; i < added_.size(); ++i) {
      const std::size_t index = added_[i].index;
      if (index >= size || (i > 0 && added_[i - 1].index == index)) {
        return fail(ErrorCode::kInvalidArgument,
                    "place " + std::to_string(index + 1) + " of " + std::to_string(size) +
                        (index >= size ? " is beyond the end" : " is used twice"));
      }
    }
    return merge(old, size);
  }

 private:
  struct Placed {
    std::size_t index;
    Id id;
  };

  Reordered<Id> merge(std::span<const Id> old, std::size_t size) const {
    Reordered<Id> result;
    result.from = old.size();
    if (!removed_.empty()) result.from = std::min(result.from, removed_.front());
    if (!added_.empty()) result.from = std::min(result.from, added_.front().index);
    result.size = size;
    result.tail.reserve(size - result.from);
    auto gone = removed_.begin();
    auto added = added_.begin();
    std::size_t next = result.from;
    for (std::size_t i = result.from; i < size; ++i) {
      if (added != added_.end() && added->index == i) {
        result.tail.push_back((added++)->id);
        continue;
      }
      for (; gone != removed_.end() && *gone == next; ++gone) ++next;
      result.tail.push_back(old[next++]);
    }
    return result;
  }

  std::vector<std::size_t> removed_;
  std::vector<Placed> added_;
  std::vector<Placed> kept_;
};

}  // namespace felt
