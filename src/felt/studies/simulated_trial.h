#pragma once

#include <vector>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/document/drawing.h"
#include "felt/studies/study_files.h"
#include "felt/studies/study_folder.h"
#include "felt/trial/study_order.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// One attempt of a simulated person at a trial.
struct SimulatedAttempt {
  TrialResult result;
  TrialMetrics metrics;
  Drawing drawing;  ///< with its recording
};

/// Lets a person draw one trial of a study with a simulated device, in a haptic loop on a virtual
/// clock: until no catch rule is broken, if the study repeats trials. A person makes the same
/// movement with the same noise in all conditions of a study (common random numbers), but slower on
/// a plane than in the air, if the person is cautious. Without forces (StudyForces::kAir), nothing
/// stops the pen at the surface. Fails if the drawing of an attempt cannot be made.
Result<std::vector<SimulatedAttempt>> simulate_trial(const StudyFiles& files,
                                                     const PlannedTrial& trial,
                                                     const Person& person,
                                                     const StylusPreset& device);

}  // namespace felt
