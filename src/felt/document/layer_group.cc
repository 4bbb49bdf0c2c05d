#include "felt/document/layer_group.h"

#include <algorithm>
#include <set>

namespace felt {

bool equal_groups(const LayerGroupPtr& a, const LayerGroupPtr& b) noexcept {
  return a == b || (a && b && *a == *b);
}

bool same_group(const LayerGroupPtr& a, const LayerGroupPtr& b) noexcept {
  return a && b && a->id == b->id;
}

void separate_groups(std::span<LayerGroupPtr* const> groups, GroupNumbers numbers) {
  GroupId last;
  std::set<GroupId> kept, used;
  if (numbers == GroupNumbers::kKept) {
    for (const LayerGroupPtr* group : groups) {
      if (*group) kept.insert((*group)->id);
    }
  }
  for (std::size_t i = 0; i < groups.size();) {
    const LayerGroupPtr first = *groups[i];
    std::size_t end = i + 1;
    while (end < groups.size() && same_group(first, *groups[end])) ++end;
    if (first) {
      const bool keeps_id =
          numbers == GroupNumbers::kKept && first->id && used.insert(first->id).second;
      LayerGroup group = *first;
      if (!keeps_id) {
        do ++last.value;
        while (kept.contains(last));
        group.id = last;
      }
      const auto shared = keeps_id ? first : std::make_shared<const LayerGroup>(std::move(group));
      for (std::size_t k = i; k < end; ++k) *groups[k] = shared;
    }
    i = end;
  }
}

}  // namespace felt
