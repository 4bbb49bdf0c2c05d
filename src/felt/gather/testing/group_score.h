#pragma once

#include <cstdint>
#include <span>

namespace felt {

/// How well groups agree with labels.
struct GroupScore {
  /// Adjusted Rand index: 1 if both agree, 0 on average for random groups (Hubert, Arabie,
  /// "Comparing partitions", 1985, doi:10.1007/BF01908075).
  double rand_index = 1.0;
  double precision = 1.0;  ///< of the pairs in one group: the share with one label
  double recall = 1.0;     ///< of the pairs with one label: the share in one group
};

/// Requires spans of the same size.
GroupScore group_score(std::span<const std::uint32_t> labels,
                       std::span<const std::uint32_t> groups);

}  // namespace felt
