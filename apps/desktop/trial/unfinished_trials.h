#pragma once

#include <span>
#include <string>

#include "felt/document/drawing.h"
#include "felt/session/event.h"
#include "felt/studies/study_folder.h"

namespace felt::desktop {

/// Returns the name of the file with the events of a trial that is in progress:
/// "unfinished-12-1.ndjson". It is in the folder of the session.
std::string unfinished_name(int trial, int attempt);

/// Adds the trials that a crash has interrupted to the session, as results with the rule
/// kInterrupted, and deletes their files. Such a result has all samples that were written, but no
/// forces. Files without a pen sample, and files of trials that were saved, are only deleted.
/// Returns the number of trials added. Fails if a file cannot be read or a trial cannot be saved;
/// the message names the file.
Result<int> recover_unfinished_trials(StudyFolder& folder, StudySession& session);

/// Applies the events of a trial to a new session, and returns the drawing with the recording of
/// these events. `device` is the name of the device. Fails if an event is refused.
Result<Drawing> drawing_of_events(std::span<const Event> events, const std::string& device);

}  // namespace felt::desktop
