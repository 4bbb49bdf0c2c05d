#pragma once

#include <string>
#include <vector>

#include "felt/store/felt_recording.h"
#include "felt/studies/export/study_results.h"

namespace felt {

/// A file of an export. `path` is relative to the folder of the export.
struct ExportFile {
  std::string path;
  std::string bytes;
};

/// The movements of a study in the form of the Brain Imaging Data Structure, BIDS 1.9, motion
/// (https://bids-specification.readthedocs.io/en/v1.9.0/modality-specific-files/motion.html). Each
/// attempt of a trial is a run. Paths are relative to the data set.

/// Returns the files of one attempt: the samples, their channels and description, and the event
/// that says which trial it is. `run` is its number in the session, from 1.
std::vector<ExportFile> bids_run_files(const StudyResults& results, const MeasuredTrial& trial,
                                       const FeltRecording& recording, std::size_t run);

/// Returns the files that describe the data set and its participants.
std::vector<ExportFile> bids_dataset_files(const StudyResults& results);

}  // namespace felt
