#pragma once

#include <QIcon>
#include <QPalette>
#include <QString>
#include <array>
#include <cstdint>
#include <functional>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/materials/media_pictures.h"
#include "felt/tools/choice_ring.h"

namespace felt::desktop {

/// The rings of RingMenu.
enum class RingContent : std::uint8_t {
  kTools,
  kMedia,
  kSizes,  ///< widths of new lines, or sizes of a tool that has a size of its own
};

/// A choice of a ring.
struct RingWell {
  QString name;
  QIcon icon;
  bool is_current = false;  ///< in use now
  /// Carries out the choice; empty for a choice that opens the ring `opens`.
  std::function<void()> choose;
  RingContent opens = RingContent::kTools;
};

/// The command that opens a ring: "tool.ring", "tool.media_ring", "tool.size_ring".
QString ring_command(RingContent content);
/// Returns the name of a ring for screen readers: "Ring of tools".
QString ring_name(RingContent content);

/// Returns the choices of a ring, clockwise from the top. Their directions never change, because a
/// hand learns them. Pencil and eraser are opposite each other; sizes grow clockwise. The arguments
/// must outlive the result.
std::array<RingWell, ChoiceRing::kWells> ring_wells(RingContent content, const Actions& actions,
                                                    Studio& studio, const MediaPictures& pictures,
                                                    const QPalette& palette);

}  // namespace felt::desktop
