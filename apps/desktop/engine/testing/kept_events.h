#pragma once

#include <functional>
#include <vector>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Returns a function for StudioOptions::connect_early. It makes the studio append every event of
/// its sessions to `events`.
inline std::function<void(Studio&)> keep_events(std::vector<Event>& events) {
  return [&events](Studio& studio) {
    QObject::connect(&studio, &Studio::event_applied, &studio,
                     [&events](const Event& event) { events.push_back(event); });
  };
}

}  // namespace felt::desktop
