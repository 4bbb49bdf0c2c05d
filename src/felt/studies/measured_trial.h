#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/document.h"
#include "felt/store/felt_recording.h"
#include "felt/studies/study_files.h"
#include "felt/trial/ink_metrics.h"
#include "felt/trial/study_order.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// The diameter of the targets of the task `connect`, at both ends of the path.
inline constexpr double kConnectTargetMm = 5.0;

/// The results of broken_rule(), apart from "".
inline constexpr std::array<std::string_view, 5> kCatchRuleNames = {
    "device_fault", "min_length_share", "max_lifts", "max_mm_per_s", "left_tunnel"};

/// Returns the samples of a recording as those of a trial. Forces are in the page plane. The
/// position of a sample in contact is that of the nib, which a stabiliser keeps away from the pen.
/// The ink from the nib to the pen, which is added when the pen lifts, has samples of its own;
/// those of the pen may then not be in order of time, and measure_trial() ignores them until they
/// are.
std::vector<TrialSample> trial_samples(const FeltRecording& recording);

/// Returns the path with which the ink of a trial is compared, and the geometry of its task. For
/// the task `copy`, the path is moved so that the centre of its bounding box is that of the ink.
StudyPath compared_path(const StudyFiles& files, const PlannedTrial& trial,
                        std::span<const TrialSample> samples);
TrialGeometry geometry_of(const StudyFiles& files, const PlannedTrial& trial);

/// Returns the page of a trial with the task `erase`. It is the same in all conditions and for all
/// participants. Requires this task.
ErasedPage erased_page_of(const StudyFiles& files, const PlannedTrial& trial);

/// Returns the metrics of a trial that follow from its samples. The same recording always gives the
/// same metrics. An eraser has no errors: they are nullopt for the task `erase`.
TrialMetrics measure_recorded_trial(const StudyFiles& files, const PlannedTrial& trial,
                                    std::span<const TrialSample> samples);
/// The same, and the metrics of the ink on the page after the trial.
TrialMetrics measure_recorded_trial(const StudyFiles& files, const PlannedTrial& trial,
                                    std::span<const TrialSample> samples, const Document& page);

/// Returns the first catch rule that a trial broke, as the name of its key in a study file
/// ("min_length_share"), or "" if the trial is valid.
std::string broken_rule(const CatchRules& rules, const TrialMetrics& metrics, double path_length_mm,
                        bool had_device_fault);

}  // namespace felt
