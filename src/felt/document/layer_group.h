#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "felt/document/blend_mode.h"
#include "felt/document/id.h"

namespace felt {

/// A group of layers that are shown, hidden, locked, faded and moved together. Immutable. Every
/// layer of the group has it as a value in its state (LayerState::group), so that the list of
/// layers stays flat. A group exists as long as it has layers. In a document, the layers of a group
/// are neighbours, and their groups are equal.
struct LayerGroup {
  GroupId id;
  std::string name;
  bool visible = true;
  bool locked = false;
  /// 0..1, of the group as a whole: its layers do not show through each other.
  double opacity = 1.0;
  BlendMode blend = BlendMode::kNormal;  ///< of the group as a whole with everything below it

  friend bool operator==(const LayerGroup&, const LayerGroup&) = default;

  /// Returns true if drawing its layers one by one does not give the picture of the group. The
  /// blend modes of its layers then apply within the group only, as in CSS.
  [[nodiscard]] bool is_whole() const noexcept {
    return opacity < 1.0 || blend != BlendMode::kNormal;
  }
};

using LayerGroupPtr = std::shared_ptr<const LayerGroup>;

/// Returns true if both are null or equal by value.
[[nodiscard]] bool equal_groups(const LayerGroupPtr& a, const LayerGroupPtr& b) noexcept;

/// Returns true if both groups exist and have the same id.
[[nodiscard]] bool same_group(const LayerGroupPtr& a, const LayerGroupPtr& b) noexcept;

/// How separate_groups() numbers groups.
enum class GroupNumbers {
  kKept,     ///< a group keeps its id; a part that is not next to the others gets the smallest free
             ///< one
  kFromOne,  ///< 1, 2 and so on, the lowest first
};

/// Makes the groups of layers valid, which are given in their order: parts of a group that are not
/// neighbours become separate groups, and all layers of a group get the group of its lowest layer.
void separate_groups(std::span<LayerGroupPtr* const> groups, GroupNumbers numbers);

}  // namespace felt
