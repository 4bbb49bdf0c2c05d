#pragma once

#include <memory>

#include "desktop/engine/pen_device.h"
#include "desktop/trial/trial_request.h"
#include "felt/autosave/folder_lock.h"
#include "felt/base/result.h"
#include "felt/studies/study_folder.h"

namespace felt::desktop {

/// A session that can begin.
struct TrialSetup {
  StudyFolder folder;
  StudySession session;
  FolderLock lock;  ///< of the folder with the results
};

/// Reads the study of a request, checks that the device can make its conditions, creates or opens
/// the folder with the results, and begins or continues the session. Trials that a crash has
/// interrupted are added to the session. `device_label` and `device` describe the device.
///
/// Fails, with a message for the researcher, if one of these steps fails, if the folder has the
/// results of another study, if another program uses it, or if the session is finished. Creates
/// nothing if the study or the device is refused.
Result<TrialSetup> prepare_trials(const TrialRequest& request, const QString& device_label,
                                  const Capabilities& device);

/// Does everything that a request asks for: prints errors to stderr before a window opens, and then
/// shows the full screen until the session ends. Uses the pen device of the user's settings.
/// Returns the exit code of the program. Requires a QApplication.
int run_trials(const TrialRequest& request);

}  // namespace felt::desktop
