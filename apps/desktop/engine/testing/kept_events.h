#pragma once

#include <functional>
#include <vector>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// For StudioOptions::connect_early: appends every event of the studio's sessions to `events`.
inline std::function<void(Studio&)> keep_events(std::vector<Event>& events) {
  return [&events](Studio& studio) {
    QObject::connect(&studio, &Studio::event_applied, &studio,
                     [&events](const Event& event) { events.push_back(event); });
  };
}

}  // namespace felt::desktop
