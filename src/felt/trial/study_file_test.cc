#include "felt/trial/study_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

#include "felt/trial/study_keys.h"
#include "felt/trial/study_order.h"

namespace felt::study_file_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kOneCondition = "[[condition]]\nname = \"free\"\n";
const std::string kOneShape = "[[shape]]\nname = \"circle\"\nkind = \"circle\"\n";

/// Returns a study whose line 2 is `line`, with a condition in line 3 and a shape in line 5.
std::string with_top(const std::string& line) {
  return "id = \"s\"\n" + line + "\n" + kOneCondition + kOneShape;
}
/// Returns a study with `line` as line 4, in its condition.
std::string with_condition(const std::string& line) {
  return "id = \"s\"\n" + kOneCondition + line + "\n" + kOneShape;
}
/// Returns a study with `line` as line 7, in its shape.
std::string with_shape(const std::string& line) {
  return "id = \"s\"\n" + kOneCondition + kOneShape + line + "\n";
}

std::string error_of(const std::string& text) {
  const Result<Study> study = read_study(text, "s.toml");
  return study ? "none" : study.error().message;
}

std::vector<std::string> problems_of(const std::string& text) {
  std::vector<std::string> messages;
  for (const Error& error : study_problems(text, "s.toml")) messages.push_back(error.message);
  return messages;
}

TEST(StudyFile, ReadsEveryKey) {
  const Result<Study> read = read_study(R"(
id = "reach"
label = "Reach"
source = "Nobody, 2026"
seed = 7
order = "balanced-latin-square"
shape_order = "random"
sessions = ["pre", "train", "post", "retention", "transfer"]
blocks = 3
repetitions = 2
practice_trials = 4
blind = true
[rest]
seconds = 20.5
after_trials = 30
[catch]
min_length_share = 0.5
max_lifts = 0
max_mm_per_s = 200
left_tunnel = true
device_fault = false
action = "repeat"
max_repeats = 2
[questions]
forms = ["nasa-tlx", "ueq-s"]
after = "session"
[[condition]]
name = "none"
forces = false
vision = false
needs = "force"
[[condition]]
name = "teacher"
label = "As the teacher draws"
guidance = "replayed-teacher"
strength = 0.5
teacher = "teacher.ndjson"
sessions = ["train"]
[condition.settings]
"pencil.stabiliser" = "towed"
pencil.strength = 0.25
pull.free_ends = true
[[shape]]
name = "circle"
kind = "circle"
task = "tunnel"
size_mm = 60
tunnel_mm = 4.5
[[shape]]
name = "mine"
file = "mine.svg"
task = "find"
sessions = ["pre", "post"]
)");
  ASSERT_TRUE(read) << read.error().message;
  Study study;
  study.id = "reach";
  study.label = "Reach";
  study.source = "Nobody, 2026";
  study.seed = 7;
  study.order = StudyOrder::kBalancedLatinSquare;
  study.shape_order = StudyOrder::kRandom;
  study.sessions = {SessionKind::kPre, SessionKind::kTrain, SessionKind::kPost,
                    SessionKind::kRetention, SessionKind::kTransfer};
  study.blocks = 3;
  study.repetitions = 2;
  study.practice_trials = 4;
  study.is_blind = true;
  study.rest_s = 20.5;
  study.rest_after_trials = 30;
  study.catch_rules = {0.5, 0, true, 200.0, false, CatchAction::kRepeat, 2};
  study.questionnaires = {Questionnaire::kNasaTlx, Questionnaire::kUeqS};
  study.question_time = QuestionTime::kSession;
  study.conditions = {{.name = "none",
                       .label = "None",
                       .forces = StudyForces::kAir,
                       .has_vision = false,
                       .needs = DeviceNeed::kForce,
                       .line = 28},
                      {.name = "teacher",
                       .label = "As the teacher draws",
                       .settings = {{"pencil.stabiliser", std::string("towed"), 40},
                                    {"pencil.strength", 0.25, 41},
                                    {"pull.free_ends", true, 42}},
                       .guidance = StudyGuidance::kReplayedTeacher,
                       .strength = 0.5,
                       .teacher = "teacher.ndjson",
                       .sessions = {SessionKind::kTrain},
                       .line = 33}};
  study.shapes = {{.name = "circle",
                   .kind = StudyShapeKind::kCircle,
                   .task = StudyTask::kTunnel,
                   .size_mm = 60.0,
                   .tunnel_mm = 4.5,
                   .line = 44},
                  {.name = "mine",
                   .kind = StudyShapeKind::kFile,
                   .file = "mine.svg",
                   .task = StudyTask::kFind,
                   .sessions = {SessionKind::kPre, SessionKind::kPost},
                   .line = 50}};
  EXPECT_TRUE(*read == study);
}

TEST(StudyFile, HasDefaults) {
  const Study study = read_study(with_top("")).value();
  EXPECT_EQ(study.label, "S");
  EXPECT_THAT(study.sessions, ElementsAre(SessionKind::kTrain));
  EXPECT_TRUE(study.catch_rules.device_fault);
  EXPECT_EQ(study.catch_rules.action, CatchAction::kFlag);
  EXPECT_EQ(study.conditions[0].label, "Free");
  EXPECT_TRUE(study.conditions[0].forces == StudyForces::kAll && study.conditions[0].has_vision);
  EXPECT_EQ(study.shapes[0].size_mm, std::nullopt);
}

// For every key with a range: the number beyond it, NaN, infinity, and values of other types.
TEST(StudyFile, RefusesValuesOutOfRangeOrOfAnotherType) {
  int refused = 0;
  for (const StudyKey& key : study_keys()) {
    if (key.kind == StudyKeyKind::kSettings) continue;
    const std::string table(study_table_of(key.id));
    const std::string name(key.id.substr(table.empty() ? 0 : table.size() + 1));
    std::vector<std::string> values = {"nan",
                                       "inf",
                                       "-inf",
                                       "-1",
                                       "1e300",
                                       "\"\"",
                                       "\"a/b\"",
                                       "1979-05-27",
                                       "[]",
                                       "[[1]]",
                                       "{}",
                                       "{a = 1}",
                                       "\"" + std::string(201, 'x') + "\"",
                                       "\"a\\u0007b\""};
    if (key.kind != StudyKeyKind::kSwitch && !key.takes_switch) values.push_back("true");
    if (key.kind == StudyKeyKind::kWhole) values.push_back("1.5");
    if (key.kind == StudyKeyKind::kText) std::erase(values, "\"a/b\"");
    if (key.id == "id") std::erase(values, "{a = 1}");  // then the id is missing
    for (const std::string& value : values) {
      const std::string line = name + " = " + value;
      const bool is_name = name == "name" || name == "kind" || name == "id";
      std::string text = with_top(table.empty() ? line : "[" + table + "]\n" + line);
      if (name == "id") text = "\n" + line + "\n" + kOneCondition + kOneShape;
      if (table == "condition") text = with_condition(line);
      if (table == "shape") text = with_shape(line);
      if (table == "hypothesis") text = with_top("") + "[[hypothesis]]\n" + line + "\n";
      if (is_name && table == "condition")
        text = "id = \"s\"\n\n[[condition]]\n" + line + "\n" + kOneShape;
      if (is_name && table == "shape") {
        text = "id = \"s\"\n" + kOneCondition + "\n\n[[shape]]\n" + line + "\n" +
               (name == "kind" ? "name = \"n\"\n" : "kind = \"line\"\n");
      }
      const int at = table.empty()           ? 2
                     : table == "condition"  ? 4
                     : table == "shape"      ? 7
                     : table == "hypothesis" ? 9
                                             : 3;
      const std::string error = error_of(text);
      EXPECT_THAT(error, StartsWith("s.toml:" + std::to_string(at) + ": " + std::string(key.id)))
          << text;
      if (value != "{a = 1}") {
        EXPECT_THAT(error, HasSubstr("it must be " + allowed_text(key)));
      }
      ++refused;
    }
  }
  EXPECT_GT(refused, 400);
}

TEST(StudyFile, NamesLineKeyAndWhatIsAllowed) {
  EXPECT_EQ(error_of(with_condition("guidance = \"grove\"")),
            "s.toml:4: condition.guidance is \"grove\", it must be one of none, groove, as-needed, "
            "error-amplifying, replayed-teacher");
  EXPECT_EQ(error_of(with_top("blocks = 0")),
            "s.toml:2: blocks is 0, it must be a whole number from 1 to 100");
  EXPECT_EQ(error_of(with_top("sessions = [\n\"pre\",\n\"prre\"]")),
            "s.toml:4: sessions has \"prre\", it must be a list of different values of pre, train, "
            "post, retention, transfer");
  EXPECT_EQ(error_of(with_top("sessions = [\"pre\", \"pre\"]")),
            "s.toml:2: sessions has \"pre\" twice");
  EXPECT_EQ(error_of(with_top("blocks = [1, 2]")),
            "s.toml:2: blocks is a list, it must be a whole number from 1 to 100");
}

TEST(StudyFile, ReadsTheTasksThatHaveTheirOwnKeys) {
  const std::string text =
      "id = \"s\"\n" + kOneCondition +
      "[[shape]]\nname = \"a\"\nkind = \"line\"\ntask = \"width\"\nwidth_mm = 2.5\n"
      "[[shape]]\nname = \"b\"\nkind = \"star\"\ntask = \"close\"\n"
      "[[shape]]\nname = \"c\"\nkind = \"wave\"\ntask = \"retrace\"\n"
      "[[shape]]\nname = \"d\"\nkind = \"line\"\ntask = \"erase\"\n";
  const Result<Study> study = read_study(text);
  ASSERT_TRUE(study) << study.error().message;
  EXPECT_EQ(study->shapes[0].task, StudyTask::kWidth);
  EXPECT_EQ(study->shapes[0].width_mm, 2.5);
  EXPECT_EQ(study->shapes[1].task, StudyTask::kClose);
  EXPECT_EQ(study->shapes[2].task, StudyTask::kRetrace);
  EXPECT_EQ(study->shapes[3].task, StudyTask::kErase);
}

TEST(StudyFile, RefusesShapesThatDoNotSuitTheTask) {
  EXPECT_THAT(
      error_of(with_shape("task = \"width\"")),
      StartsWith("s.toml:7: shape.width_mm is missing; the task width requires it, 0.3 to 6"));
  EXPECT_THAT(error_of(with_shape("width_mm = 2")),
              StartsWith("s.toml:7: shape.width_mm has no effect without the task width"));
  EXPECT_THAT(error_of(with_shape("task = \"width\"\nwidth_mm = 9")),
              HasSubstr("shape.width_mm is 9, it must be 0.3 to 6"));
  const std::string line =
      "id = \"s\"\n" + kOneCondition + "[[shape]]\nname = \"a\"\nkind = \"line\"\n";
  EXPECT_EQ(error_of(line + "task = \"close\"\n"),
            "s.toml:6: shape.kind is \"line\", it must be \"circle\" or \"star\" for the task "
            "close");
  EXPECT_EQ(error_of(line + "task = \"erase\"\nsize_mm = 30\n"),
            "s.toml:8: shape.size_mm is 30, it must be 50 to 250 for the task erase");
  EXPECT_THAT(error_of("id = \"s\"\n" + kOneCondition +
                       "[[shape]]\nname = \"a\"\nkind = \"wave\"\ntask = \"erase\"\n"),
              HasSubstr("shape.kind must be \"line\" for the task erase"));
  EXPECT_THAT(error_of("id = \"s\"\n" + kOneCondition +
                       "[[shape]]\nname = \"a\"\nfile = \"b.svg\"\ntask = \"erase\"\n"),
              HasSubstr("shape.kind must be \"line\" for the task erase"));
}

TEST(StudyFile, RefusesUnknownKeys) {
  EXPECT_THAT(
      error_of(with_top("colour = 1")),
      StartsWith("s.toml:2: colour is unknown; a study has id, label, source, seed, people, "));
  EXPECT_THAT(error_of(with_top("colour = 1")),
              testing::EndsWith("blind, [rest], [catch], [questions], [[condition]], [[shape]], "
                                "[[hypothesis]]"));
  EXPECT_EQ(error_of(with_top("rest.second = 1")),
            "s.toml:2: rest.second is unknown; [rest] has seconds, after_trials");
  EXPECT_THAT(error_of(with_condition("guidence = 1")),
              StartsWith("s.toml:4: condition.guidence is unknown; [[condition]] has name, label"));
  EXPECT_THAT(error_of(with_shape("size = 1")),
              StartsWith("s.toml:7: shape.size is unknown; [[shape]] has name, kind, file"));
  EXPECT_THAT(error_of(with_top("\"condition.name\" = 1")), HasSubstr("is unknown"));
  EXPECT_THAT(error_of(with_top("\"a\\u001bb\" = 1")), HasSubstr(":2: a\\x1bb is unknown"));
  EXPECT_THAT(error_of(with_top("") + "[[trial]]\nname = \"x\"\n"),
              HasSubstr("trial.name is unknown"));
  EXPECT_THAT(error_of(with_top("") + "[colours]\n"), HasSubstr("colours is unknown"));
}

TEST(StudyFile, RefusesTablesOfTheWrongForm) {
  EXPECT_EQ(error_of("id = \"s\"\n[condition]\nname = \"free\"\n" + kOneShape),
            "s.toml:3: condition must be written as [[condition]]");
  EXPECT_EQ(error_of("id = \"s\"\n" + kOneCondition + "[shape]\n"),
            "s.toml:4: shape must be written as [[shape]]");
  EXPECT_THAT(error_of("id = \"s\"\ncondition = 3\n" + kOneShape),
              HasSubstr("2: condition must be written as [[condition]]"));
  EXPECT_THAT(error_of("id = \"s\"\ncondition = [3, {name = \"a\"}]\n" + kOneShape),
              HasSubstr("2: condition must be written as [[condition]]"));
  EXPECT_EQ(error_of(with_top("") + "[[rest]]\nseconds = 3\n"),
            "s.toml:9: rest must be written as [rest]");
  EXPECT_EQ(error_of(with_top("rest = {}")), "none");
  EXPECT_THAT(error_of(with_condition("[[condition.settings]]\na.b = 1")),
              HasSubstr("condition.settings is a list, it must be a table"));
}

TEST(StudyFile, RefusesWhatIsMissing) {
  EXPECT_THAT(problems_of(""),
              ElementsAre(HasSubstr("1: id is missing"),
                          HasSubstr("1: condition is missing; a study has 1 to 26"),
                          HasSubstr("1: shape is missing; a study has 1 to 100")));
  EXPECT_THAT(error_of("id = \"s\"\n[[condition]]\n" + kOneShape),
              StartsWith("s.toml:2: condition.name is missing"));
  EXPECT_THAT(error_of("id = \"s\"\n" + kOneCondition + "[[shape]]\nname = \"x\"\n"),
              StartsWith("s.toml:5: shape.kind is missing; it must be one of line, circle"));
}

TEST(StudyFile, RefusesNamesThatAreUsedTwice) {
  EXPECT_EQ(error_of(with_top("") + kOneCondition),
            "s.toml:9: condition.name is \"free\", it must be different from the name in line 4");
  EXPECT_EQ(error_of(with_top("") + kOneShape),
            "s.toml:9: shape.name is \"circle\", it must be different from the name in line 6");
}

TEST(StudyFile, NamesTheForcesOrSwitchesThem) {
  const std::pair<const char*, StudyForces> texts[] = {{"\"air\"", StudyForces::kAir},
                                                       {"false", StudyForces::kAir},
                                                       {"\"plane\"", StudyForces::kPlane},
                                                       {"\"all\"", StudyForces::kAll},
                                                       {"true", StudyForces::kAll}};
  for (const auto& [text, forces] : texts) {
    const auto read = read_study(with_condition("forces = " + std::string(text)), "a.toml");
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(read->conditions[0].forces, forces) << text;
  }
}

TEST(StudyFile, RefusesKeysThatDoNotFitOthers) {
  const std::vector<std::pair<std::string, std::string>> pairs = {
      {with_condition("strength = 0.5"), "4: condition.strength has no effect"},
      {with_condition("guidance = \"none\"\nstrength = 0.5"),
       "5: condition.strength has no effect"},
      {with_condition("teacher = \"a\""), "4: condition.teacher has no effect"},
      {with_condition("guidance = \"replayed-teacher\""), "4: condition.teacher is missing"},
      {with_condition("guidance = \"groove\"\nforces = false"), "5: condition.forces is false"},
      {with_condition("guidance = \"groove\"\nforces = \"plane\""),
       "5: condition.forces is \"plane\""},
      {with_condition("sessions = [\"pre\"]"), "4: condition.sessions is \"pre\", it must be in"},
      {with_shape("file = \"a.svg\""), "7: shape has a kind and a file"},
      {with_shape("tunnel_mm = 3"), "7: shape.tunnel_mm has no effect"},
      {with_shape("task = \"tunnel\""), "7: shape.tunnel_mm is missing"},
      {with_shape("sessions = [\"post\"]"), "7: shape.sessions is \"post\", it must be in"},
      {with_top("rest.after_trials = 3"), "2: rest.after_trials has no effect"},
      {with_top("catch.left_tunnel = true"), "2: catch.left_tunnel has no effect"},
      {with_top("catch.max_repeats = 2"), "2: catch.max_repeats has no effect"},
      {with_top("catch = {device_fault = false, action = \"repeat\"}"), "2: catch.action has no"},
      {with_top("questions.after = \"session\""), "2: questions.after has no effect"},
      {"id = \"s\"\nsessions = [\"pre\", \"post\"]\n" + kOneCondition + "sessions = [\"pre\"]\n" +
           kOneShape,
       "2: sessions: \"post\" has no condition"},
      {"id = \"s\"\nsessions = [\"pre\", \"post\"]\n" + kOneCondition + kOneShape +
           "sessions = [\"pre\"]\n",
       "2: sessions: \"post\" has no shape"}};
  for (const auto& [text, error] : pairs) {
    EXPECT_THAT(problems_of(text), ElementsAre(StartsWith("s.toml:" + error))) << text;
  }
}

TEST(StudyFile, RefusesSettingsThatAreNotOptions) {
  EXPECT_EQ(error_of(with_condition("settings = {a.b = 1, \"c.d_e\" = \"x\"}")), "none");
  for (const char* settings : {"a = 1", "\"a\" = 1", "\".a\" = 1", "\"a.\" = 1", "\"a.b.c\" = 1",
                               "\"A.b\" = 1", "a.\"b.c\" = 1", "a = {}", "\"a b.c\" = 1"}) {
    EXPECT_THAT(error_of(with_condition("settings = {" + std::string(settings) + "}")),
                HasSubstr("the keys of condition.settings must be options"))
        << settings;
  }
  for (const char* value : {"nan", "inf", "\"\"", "1979-05-27", "[1, 2]", "[]"}) {
    EXPECT_THAT(problems_of(with_condition("settings = {a.b = " + std::string(value) + "}")),
                ElementsAre(StartsWith("s.toml:4: condition.settings.a.b is ")))
        << value;
  }
  EXPECT_EQ(error_of(with_condition("settings = {a.b = 1, \"a.b\" = 2}")),
            "s.toml:4: condition.settings has a.b twice");
  EXPECT_THAT(error_of(with_condition("settings = 1")), HasSubstr("must be a table of options"));
  std::string many;
  for (std::size_t i = 0; i <= kMaxConditionSettings; ++i) {
    many += "settings.a.o" + std::to_string(i) + " = 1\n";
  }
  EXPECT_THAT(error_of(with_condition(many)), HasSubstr("more than 40 options"));
}

TEST(StudyFile, RefusesWhatIsNotToml) {
  EXPECT_THAT(error_of("id = \n"), StartsWith("s.toml:1: "));
  EXPECT_THAT(error_of("id = \"s\"\nid = \"s\"\n"), StartsWith("s.toml:2: "));
  EXPECT_EQ(error_of("id = \"\xff\""), "s.toml: is not UTF-8");
  EXPECT_THAT(error_of("id = \"s\"\na.b.c.d.e = 1\n"), HasSubstr("too deeply for a study"));
}

TEST(StudyFile, RefusesWhatIsTooLarge) {
  EXPECT_EQ(error_of(std::string(kMaxStudyBytes + 1, '\n')), "s.toml: is longer than 64 KiB");
  EXPECT_EQ(error_of("\n# " + std::string(500, 'x')), "s.toml:2: is longer than 500 bytes");
  std::string conditions = "id = \"s\"\n" + kOneShape, shapes = "id = \"s\"\n" + kOneCondition;
  for (int i = 0; i < 800; ++i) {
    const std::string name = "name = \"n" + std::to_string(i) + "\"\n";
    conditions += "[[condition]]\n" + name;
    shapes += "[[shape]]\n" + name + "kind = \"line\"\n";
  }
  EXPECT_EQ(error_of(conditions), "s.toml:58: condition: a study has at most 26 of them");
  EXPECT_EQ(error_of(shapes), "s.toml:305: shape: a study has at most 100 of them");
  conditions = "id = \"s\"\n";
  for (int i = 0; i < 3000; ++i) conditions += "x" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(problems_of(conditions).size(), kMaxStudyProblems);
  EXPECT_EQ(error_of(with_top("blocks = 100\nrepetitions = 100")),
            "s.toml:2: blocks: session \"train\" has 10000 trials, it must have at most 2000");
}

TEST(StudyFile, ReportsAllProblemsInTheOrderOfLines) {
  const std::string text =
      "id = \"S\"\nblocks = 0\nunknown = 1\n[[condition]]\nname = \"a\"\nguidance = \"x\"\n"
      "strength = 2\n[[condition]]\nname = \"a\"\n[[shape]]\nname = \"b\"\nkind = \"hexagon\"\n";
  EXPECT_THAT(
      problems_of(text),
      ElementsAre(HasSubstr(":1: id "), HasSubstr(":2: blocks "), HasSubstr(":3: unknown "),
                  HasSubstr(":6: condition.guidance "), HasSubstr(":7: condition.strength "),
                  HasSubstr(":9: condition.name "), HasSubstr(":12: shape.kind ")));
}

// Any change of a valid text gives a study that can be planned, or an error with the file's name.
RC_GTEST_PROP(StudyFile, NeverFailsInAnotherWay, ()) {
  std::string text = with_condition("guidance = \"groove\"\nsettings = {\"a.b\" = 1}");
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const std::string part = *rc::gen::element<std::string>("", "[", "]", "\n", "\"", "=", ".",
                                                            "[[", "{", "}", "1", "a");
    text.replace(at, *rc::gen::inRange<std::size_t>(0, 4), part);
  }
  const Result<Study> study = read_study(text, "s.toml");
  const std::vector<std::string> problems = problems_of(text);
  RC_ASSERT(study.has_value() == problems.empty());
  for (const std::string& problem : problems) RC_ASSERT(problem.starts_with("s.toml:"));
  if (study) RC_ASSERT(plan_trials(*study, 1, study->sessions.front()).has_value());
}

}  // namespace
}  // namespace felt::study_file_test
