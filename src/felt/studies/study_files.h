#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"
#include "felt/trial/study.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// The page of every trial: A4, landscape.
inline constexpr Rect kStudyPage{0.0, 0.0, 297.0, 210.0};

/// Names in the folder with the results of a study (StudyFolder). The files that a study names have
/// other names.
inline constexpr std::string_view kStudyFileName = "study.toml";
inline constexpr std::string_view kParticipantPrefix = "participant-";
/// The largest size of a file that a study names.
inline constexpr std::size_t kMaxStudySourceBytes = std::size_t{64} << 20;

/// Returns the centre of a rectangle that is not empty.
constexpr Point middle_of(const Rect& box) noexcept {
  return {0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
}

/// The path of a shape on the page, in mm.
struct StudyPath {
  std::vector<Point> points;
  TrialPathEnds ends = TrialPathEnds::kOpen;
};

/// Returns the path with each corner given twice, as plan_movement() expects it. A closed path ends
/// where it began.
std::vector<Point> via_points(const StudyPath& path);

/// A study with everything that it needs from other files.
struct StudyFiles {
  Study study;
  /// For each shape of the study: the path that the participant draws. The centre of its bounding
  /// box is the centre of the page. For the task `copy` the box is in the right half of the page,
  /// and the participant sees the model in the left half (model_of()).
  std::vector<StudyPath> paths;
  /// For each condition: the samples of the teacher; empty unless the guidance is kReplayedTeacher.
  /// The centre of the bounding box of the samples in contact is the centre of the page, as with
  /// the paths. One recording serves all shapes of the study.
  std::vector<std::vector<TrialSample>> teachers;
  /// The names and bytes of the study and of all files that it names; the study is the first.
  std::vector<std::pair<std::string, std::string>> sources;
};

/// Reads a study and the files that it names, which are in the folder of the study. Fails if the
/// study has an error (read_study()), if a file cannot be read, if a shape file does not have
/// exactly one line, if a shape does not fit on the page, or if the recording of a teacher has no
/// sample in contact. Each message names the file; if the fault is a value of the study, also its
/// line and key.
Result<StudyFiles> read_study_files(const std::string& path);

/// Returns the model of a shape with the task `copy`: the path, moved to the left half of the page.
StudyPath model_of(const StudyPath& path);

}  // namespace felt
