#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "felt/base/result.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/studies/study_folder.h"

namespace felt {

struct SimulateOptions {
  std::size_t people = 20;
  std::uint64_t seed = 1;  ///< of the people (population())
  PersonModel model = PersonModel::kResting;
  StylusPreset device;
  std::string program;  ///< SessionInfo::program
};

/// Simulated people take part in all sessions of a study: person i of the population is participant
/// i. Each trial is drawn by a FeedbackHand in a haptic loop on a virtual clock, and recorded like
/// a trial of a real participant (simulate_trial()). Simulated people do not learn, and do not
/// answer questions. They plan the movement of a towed nib, but look at the pen, and do not correct
/// the nib.
///
/// The same study, options and machine give the same files. Trials that the folder already has are
/// kept, so that an interrupted simulation can be continued, or extended by more people. Fails if
/// the folder has the session of another person. `progress` receives the finished share,
/// 0..1, after each trial; if it returns false, the simulation ends early, and the folder keeps the
/// finished trials. Fails if a condition cannot be made (check_conditions()) or a file cannot be
/// written.
Result<void> simulate_study(StudyFolder& folder, const SimulateOptions& options,
                            const std::function<bool(double)>& progress = {});

}  // namespace felt
