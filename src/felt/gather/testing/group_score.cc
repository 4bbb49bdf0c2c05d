#include "felt/gather/testing/group_score.h"

#include <map>
#include <utility>

namespace felt {
namespace {

template <class Map>
double pairs_within(const Map& counts) {
  double pairs = 0.0;
  for (const auto& [key, n] : counts) pairs += n * (n - 1.0) / 2.0;
  return pairs;
}

}  // namespace

GroupScore group_score(std::span<const std::uint32_t> labels,
                       std::span<const std::uint32_t> groups) {
  std::map<std::uint32_t, double> of_label, of_group;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> of_both;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ++of_label[labels[i]];
    ++of_group[groups[i]];
    ++of_both[{labels[i], groups[i]}];
  }
  const double same = pairs_within(of_both);
  const double label_pairs = pairs_within(of_label), group_pairs = pairs_within(of_group);
  const auto n = static_cast<double>(labels.size());
  GroupScore score;
  if (group_pairs > 0.0) score.precision = same / group_pairs;
  if (label_pairs > 0.0) score.recall = same / label_pairs;
  const double expected = n > 1.0 ? label_pairs * group_pairs / (n * (n - 1.0) / 2.0) : 0.0;
  const double best = (label_pairs + group_pairs) / 2.0;
  if (best != expected) score.rand_index = (same - expected) / (best - expected);
  return score;
}

}  // namespace felt
