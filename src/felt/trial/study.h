#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace felt {

/// What a participant does with a shape. The names of each enum are in the array that follows it,
/// in the same order; study files and tables use these names.
enum class StudyTask {
  kTrace,    ///< draw along a visible line
  kTunnel,   ///< draw between two walls (steering law, ISO 9241-411)
  kCopy,     ///< draw the shape freely beside the model
  kConnect,  ///< draw from target to target
  kFind,     ///< find an engraved line by touch
  kRetrace,  ///< draw over a line of ink
  kClose,    ///< draw along a closed line, so that the end meets the start
  kWidth,    ///< draw along a line, as broad as required
  kErase,    ///< erase the part of a line between two lines that cross it
};
inline constexpr std::array<std::string_view, 9> kStudyTasks = {
    "trace", "tunnel", "copy", "connect", "find", "retrace", "close", "width", "erase"};

/// How forces guide the pen along the shape.
enum class StudyGuidance {
  kNone,
  kGroove,           ///< a groove along the line
  kAsNeeded,         ///< a force that grows with the error and fades as the participant improves
  kErrorAmplifying,  ///< a force away from the line
  kReplayedTeacher,  ///< the recorded pen of a teacher leads the hand
};
inline constexpr std::array<std::string_view, 5> kStudyGuidances = {
    "none", "groove", "as-needed", "error-amplifying", "replayed-teacher"};

/// Which forces the device applies: what a condition is compared with. A device without forces
/// draws the same in all three.
enum class StudyForces {
  kAir,    ///< none, not even a surface: the motors are off
  kPlane,  ///< the plane of the surface alone: no friction, grain, attraction or guide
  kAll,    ///< those of the program, with its options
};
inline constexpr std::array<std::string_view, 3> kStudyForces = {"air", "plane", "all"};

/// The order of conditions, or of the shapes in a condition.
enum class StudyOrder {
  kSequential,           ///< as in the file
  kRandom,               ///< shuffled again in each block
  kBalancedLatinSquare,  ///< plan_trials() describes the square
};
inline constexpr std::array<std::string_view, 3> kStudyOrders = {"sequential", "random",
                                                                 "balanced-latin-square"};

enum class SessionKind { kPre, kTrain, kPost, kRetention, kTransfer };
inline constexpr std::array<std::string_view, 5> kSessionKinds = {"pre", "train", "post",
                                                                  "retention", "transfer"};

/// What happens after a trial that breaks a catch rule.
enum class CatchAction {
  kFlag,    ///< the trial is marked
  kRepeat,  ///< the trial is marked, and the participant repeats it
};
inline constexpr std::array<std::string_view, 2> kCatchActions = {"flag", "repeat"};

enum class Questionnaire {
  kNasaTlx,  ///< six scales from 0 to 100, without weights (raw TLX)
  kUeqS,     ///< the short User Experience Questionnaire, eight items
};
inline constexpr std::array<std::string_view, 2> kQuestionnaires = {"nasa-tlx", "ueq-s"};

/// When the questionnaires are shown.
enum class QuestionTime {
  kCondition,  ///< after the last trial of each condition in a session
  kSession,    ///< after the last trial of a session
};
inline constexpr std::array<std::string_view, 2> kQuestionTimes = {"condition", "session"};

/// What the device of a condition must be able to do.
enum class DeviceNeed { kNothing, kForce };
inline constexpr std::array<std::string_view, 2> kDeviceNeeds = {"nothing", "force"};

enum class StudyShapeKind { kLine, kCircle, kSpiral, kWave, kStar, kFile };
/// The built-in shapes. kFile has no name, because the file has one.
inline constexpr std::array<std::string_view, 5> kStudyShapeNames = {"line", "circle", "spiral",
                                                                     "wave", "star"};

/// One option of a session, such as "pencil.stabiliser". A study keeps its id and value without
/// knowing the options that exist: the program that runs the study checks them, and uses `line` for
/// its message.
struct StudySetting {
  std::string id;
  std::variant<double, bool, std::string> value;
  int line = 0;  ///< in the study file
  friend bool operator==(const StudySetting&, const StudySetting&) = default;
};

/// One way of drawing that the study compares with others.
struct StudyCondition {
  std::string name;   ///< unique in the study: "towed-drag"
  std::string label;  ///< shown to the user
  std::vector<StudySetting> settings = {};
  StudyForces forces = StudyForces::kAll;
  bool has_vision = true;  ///< false: the screen is blank while the participant draws
  StudyGuidance guidance = StudyGuidance::kNone;
  double strength = 1.0;     ///< of the guidance, 0 to 1
  std::string teacher = {};  ///< the file of the recording for kReplayedTeacher
  DeviceNeed needs = DeviceNeed::kNothing;
  std::vector<SessionKind> sessions = {};  ///< empty: all sessions of the study
  int line = 0;                            ///< in the study file
  friend bool operator==(const StudyCondition&, const StudyCondition&) = default;
};

/// One shape that participants draw in every condition.
struct StudyShape {
  std::string name;  ///< unique in the study
  StudyShapeKind kind = StudyShapeKind::kLine;
  std::string file = {};  ///< the file name for kFile; the study reader does not open it
  StudyTask task = StudyTask::kTrace;
  /// The longer side of the bounding box. A file without it keeps its own size.
  std::optional<double> size_mm = {};
  double tunnel_mm = 0.0;                  ///< the width of the tunnel; 0 without a tunnel
  double width_mm = 0.0;                   ///< the required width of the line; 0: none
  std::vector<SessionKind> sessions = {};  ///< empty: all sessions of the study
  int line = 0;                            ///< in the study file
  friend bool operator==(const StudyShape&, const StudyShape&) = default;
};

/// What a hypothesis says about the ratio of its measure in two conditions.
enum class HypothesisKind {
  kLess,      ///< the ratio is below 1 (tested two-sided against 1)
  kNotWorse,  ///< the ratio is below 1 + margin (non-inferiority)
  kSame,      ///< the ratio is between 1 / (1 + margin) and 1 + margin (equivalence)
};
inline constexpr std::array<std::string_view, 3> kHypothesisKinds = {"less", "not-worse", "same"};

/// A primary hypothesis, which the report tests. It is about a metric of trials of which less is
/// better, over the participants who have both conditions.
struct StudyHypothesis {
  std::string condition, against;  ///< names of conditions
  std::string measure;             ///< the name of a column of trial_metric_columns()
  HypothesisKind kind = HypothesisKind::kLess;
  double margin = 0.0;                      ///< a share; 0 for kLess
  std::optional<SessionKind> session = {};  ///< absent: hypothesis_session() chooses
  int line = 0;                             ///< in the study file
  friend bool operator==(const StudyHypothesis&, const StudyHypothesis&) = default;
};

/// The rules by which a trial is invalid. Metrics of invalid trials are computed and kept, too.
struct CatchRules {
  double min_length_share = 0.0;            ///< of the length of the shape; 0: no rule
  std::optional<int> max_lifts = {};        ///< absent: no rule
  bool left_tunnel = false;                 ///< true: a trial that leaves the tunnel is invalid
  std::optional<double> max_mm_per_s = {};  ///< mean speed of the pen; absent: no rule
  bool device_fault = true;                 ///< true: a trial with a device fault is invalid
  CatchAction action = CatchAction::kFlag;
  int max_repeats = 3;  ///< of one trial, for kRepeat
  friend bool operator==(const CatchRules&, const CatchRules&) = default;
};

/// A study: which conditions are compared with which shapes, and in which order. Format:
/// docs/formats/study.md.
struct Study {
  std::string id;
  std::string label;
  std::string source = {};  ///< the publication that the study repeats
  std::uint32_t seed = 1;
  StudyOrder order = StudyOrder::kSequential;
  StudyOrder shape_order = StudyOrder::kSequential;
  std::vector<SessionKind> sessions = {SessionKind::kTrain};
  int blocks = 1;
  int repetitions = 1;        ///< of each shape in each condition of a block
  int practice_trials = 0;    ///< for each condition, before the first block
  bool is_blind = false;      ///< true: participants see "A", "B", ... instead of the conditions
  double rest_s = 0.0;        ///< 0: no rests
  int rest_after_trials = 0;  ///< a rest after so many trials; 0: only between blocks
  CatchRules catch_rules = {};
  std::vector<Questionnaire> questionnaires = {};
  QuestionTime question_time = QuestionTime::kCondition;
  std::vector<StudyCondition> conditions = {};
  std::vector<StudyShape> shapes = {};
  std::vector<StudyHypothesis> hypotheses = {};
  int people = 0;  ///< the planned number of participants; 0: not in the file
  friend bool operator==(const Study&, const Study&) = default;
};

/// Limits of a study. There are at most 26 conditions because blind labels are single letters.
inline constexpr std::size_t kMaxStudyConditions = 26;
inline constexpr std::size_t kMaxStudyShapes = 100;
inline constexpr std::size_t kMaxConditionSettings = 40;
inline constexpr std::size_t kMaxStudyHypotheses = 20;
inline constexpr std::size_t kMaxSessionTrials = 2000;
/// The length of the line of the task kErase, mm.
inline constexpr double kMinErasedLineMm = 50.0, kMaxErasedLineMm = 250.0;

}  // namespace felt
