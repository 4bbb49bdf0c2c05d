#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/haptics/capabilities.h"
#include "felt/material/materials.h"
#include "felt/session/event.h"
#include "felt/studies/study_files.h"
#include "felt/trial/study_order.h"

namespace felt {

/// Checks each condition of a study: that its settings exist and accept their values, and that the
/// device can make it. A condition that needs forces, or that guides the pen, needs a device with
/// forces, and a path of a possible length (check_guide()). Fails with the first error, which names
/// the file, the line and the key. `name` is the name of the study file.
Result<void> check_conditions(const StudyFiles& files, const Materials& materials,
                              const Capabilities& device, const std::string& name);

/// Returns the ink that is on the page when a trial begins: the line of the task `retrace`, and the
/// page of the task `erase`; nothing for the other tasks.
std::vector<AddLine> ink_at_start(const StudyFiles& files, const PlannedTrial& trial);

/// Returns the events that set up a new session for a trial, at time 0: the device, the options of
/// the condition, the guide, the ink at the start, and the tool of the task. Whether forces are on
/// is not an event: StudyCondition::forces decides it; only the choice of the plane alone is an
/// event. `ink` is the colour of new ink in the session; the ink at the start may have another one.
/// Requires that check_conditions() succeeded.
std::vector<Event> setup_events(const StudyFiles& files, const PlannedTrial& trial,
                                const Capabilities& device, Rgba ink = {});

}  // namespace felt
