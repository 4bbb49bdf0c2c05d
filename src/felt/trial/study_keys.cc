#include "felt/trial/study_keys.h"

#include <algorithm>
#include <array>

#include "felt/base/utf8.h"
#include "felt/material/material_file.h"
#include "felt/material/number_text.h"

namespace felt {
namespace {

using Kind = StudyKeyKind;
using Target = StudyTarget;
using Value = StudyValue;

constexpr std::size_t kMaxStudyTextBytes = 200;

bool is_file_name(std::string_view text) noexcept {
  return is_study_text(text) && text.find_first_of("/\\") == std::string_view::npos &&
         text != "." && text != "..";
}

int whole(const Value& value) noexcept {
  return static_cast<int>(value.number);
}

template <class Enum>
Enum choice(const Value& value) noexcept {
  return static_cast<Enum>(value.choice);
}

constexpr auto kKeys = std::to_array<StudyKey>({
    {.id = "id",
     .kind = Kind::kId,
     .fallback = "required",
     .help = "The name of the study in files and tables.",
     .set = [](const Target& t, const Value& v) { t.study->id = v.text; }},
    {.id = "label",
     .kind = Kind::kText,
     .fallback = "made from the id",
     .help = "The name that is shown.",
     .set = [](const Target& t, const Value& v) { t.study->label = v.text; }},
    {.id = "source",
     .kind = Kind::kText,
     .fallback = "none",
     .help = "The publication that the study repeats.",
     .set = [](const Target& t, const Value& v) { t.study->source = v.text; }},
    {.id = "seed",
     .kind = Kind::kWhole,
     .max = 4294967295.0,
     .fallback = "1",
     .help = "Another number gives another order of the trials.",
     .set = [](const Target& t,
               const Value& v) { t.study->seed = static_cast<std::uint32_t>(v.number); }},
    {.id = "people",
     .kind = Kind::kWhole,
     .min = 5,
     .max = 9999,
     .fallback = "none",
     .help = "The planned number of participants, for the preregistration.",
     .set = [](const Target& t, const Value& v) { t.study->people = whole(v); }},
    {.id = "order",
     .kind = Kind::kChoice,
     .choices = kStudyOrders,
     .fallback = "sequential",
     .help = "The order of the conditions in a block.",
     .set = [](const Target& t, const Value& v) { t.study->order = choice<StudyOrder>(v); }},
    {.id = "shape_order",
     .kind = Kind::kChoice,
     .choices = kStudyOrders,
     .fallback = "sequential",
     .help = "The order of the shapes in a condition.",
     .set = [](const Target& t, const Value& v) { t.study->shape_order = choice<StudyOrder>(v); }},
    {.id = "sessions",
     .kind = Kind::kChoices,
     .choices = kSessionKinds,
     .fallback = "train",
     .help = "The sessions, in their order.",
     .set = [](const Target& t,
               const Value& v) { t.study->sessions.push_back(choice<SessionKind>(v)); }},
    {.id = "blocks",
     .kind = Kind::kWhole,
     .min = 1,
     .max = 100,
     .fallback = "1",
     .help = "Blocks of a session. Each block has all conditions of the session.",
     .set = [](const Target& t, const Value& v) { t.study->blocks = whole(v); }},
    {.id = "repetitions",
     .kind = Kind::kWhole,
     .min = 1,
     .max = 100,
     .fallback = "1",
     .help = "How often each shape is drawn in each condition of a block.",
     .set = [](const Target& t, const Value& v) { t.study->repetitions = whole(v); }},
    {.id = "practice_trials",
     .kind = Kind::kWhole,
     .max = 20,
     .fallback = "0",
     .help = "Practice trials of each condition, before the first block of a session.",
     .set = [](const Target& t, const Value& v) { t.study->practice_trials = whole(v); }},
    {.id = "blind",
     .kind = Kind::kSwitch,
     .fallback = "false",
     .help = "Participants see A, B, ... instead of the names of the conditions.",
     .set = [](const Target& t, const Value& v) { t.study->is_blind = v.is_on; }},
    {.id = "rest.seconds",
     .kind = Kind::kNumber,
     .max = 3600,
     .fallback = "0",
     .help = "The shortest rest, in s, between blocks; 0 is none.",
     .set = [](const Target& t, const Value& v) { t.study->rest_s = v.number; }},
    {.id = "rest.after_trials",
     .kind = Kind::kWhole,
     .max = 1000,
     .fallback = "0",
     .help = "A rest also after so many trials without one; 0 is only between blocks.",
     .set = [](const Target& t, const Value& v) { t.study->rest_after_trials = whole(v); }},
    {.id = "catch.min_length_share",
     .kind = Kind::kNumber,
     .max = 1,
     .fallback = "0",
     .help = "A trial is invalid if its line is shorter than this share of the shape.",
     .set = [](const Target& t,
               const Value& v) { t.study->catch_rules.min_length_share = v.number; }},
    {.id = "catch.max_lifts",
     .kind = Kind::kWhole,
     .max = 1000,
     .fallback = "no limit",
     .help = "A trial is invalid if the pen is lifted more often before the end.",
     .set = [](const Target& t, const Value& v) { t.study->catch_rules.max_lifts = whole(v); }},
    {.id = "catch.max_mm_per_s",
     .kind = Kind::kNumber,
     .min = 1,
     .max = 10000,
     .fallback = "no limit",
     .help = "A trial is invalid if the mean speed of the pen is higher.",
     .set = [](const Target& t, const Value& v) { t.study->catch_rules.max_mm_per_s = v.number; }},
    {.id = "catch.left_tunnel",
     .kind = Kind::kSwitch,
     .fallback = "false",
     .help = "A trial is invalid if the pen leaves the tunnel.",
     .set = [](const Target& t, const Value& v) { t.study->catch_rules.left_tunnel = v.is_on; }},
    {.id = "catch.device_fault",
     .kind = Kind::kSwitch,
     .fallback = "true",
     .help = "A trial is invalid if the device reports a fault.",
     .set = [](const Target& t, const Value& v) { t.study->catch_rules.device_fault = v.is_on; }},
    {.id = "catch.action",
     .kind = Kind::kChoice,
     .choices = kCatchActions,
     .fallback = "flag",
     .help = "Mark an invalid trial, or mark it and repeat it.",
     .set = [](const Target& t,
               const Value& v) { t.study->catch_rules.action = choice<CatchAction>(v); }},
    {.id = "catch.max_repeats",
     .kind = Kind::kWhole,
     .min = 1,
     .max = 20,
     .fallback = "3",
     .help = "How often one trial is repeated at most.",
     .set = [](const Target& t, const Value& v) { t.study->catch_rules.max_repeats = whole(v); }},
    {.id = "questions.forms",
     .kind = Kind::kChoices,
     .choices = kQuestionnaires,
     .fallback = "none",
     .help = "The questionnaires.",
     .set = [](const Target& t,
               const Value& v) { t.study->questionnaires.push_back(choice<Questionnaire>(v)); }},
    {.id = "questions.after",
     .kind = Kind::kChoice,
     .choices = kQuestionTimes,
     .fallback = "condition",
     .help = "When they are shown: after the last trial of each condition, or of a session.",
     .set = [](const Target& t,
               const Value& v) { t.study->question_time = choice<QuestionTime>(v); }},
    {.id = "condition.name",
     .kind = Kind::kId,
     .fallback = "required",
     .help = "The name of the condition, different from the other names.",
     .set = [](const Target& t, const Value& v) { t.condition->name = v.text; }},
    {.id = "condition.label",
     .kind = Kind::kText,
     .fallback = "made from the name",
     .help = "The name that is shown.",
     .set = [](const Target& t, const Value& v) { t.condition->label = v.text; }},
    {.id = "condition.forces",
     .kind = Kind::kChoice,
     .choices = kStudyForces,
     .takes_switch = true,
     .fallback = "all",
     .help = "The forces: none and no surface (air), only the surface (plane), or all.",
     .set = [](const Target& t, const Value& v) { t.condition->forces = choice<StudyForces>(v); }},
    {.id = "condition.vision",
     .kind = Kind::kSwitch,
     .fallback = "true",
     .help = "The participant sees the drawing; if false, the screen is blank.",
     .set = [](const Target& t, const Value& v) { t.condition->has_vision = v.is_on; }},
    {.id = "condition.guidance",
     .kind = Kind::kChoice,
     .choices = kStudyGuidances,
     .fallback = "none",
     .help = "How forces guide the pen along the shape.",
     .set = [](const Target& t,
               const Value& v) { t.condition->guidance = choice<StudyGuidance>(v); }},
    {.id = "condition.strength",
     .kind = Kind::kNumber,
     .max = 1,
     .fallback = "1",
     .help = "Strength of the guidance.",
     .set = [](const Target& t, const Value& v) { t.condition->strength = v.number; }},
    {.id = "condition.teacher",
     .kind = Kind::kFile,
     .fallback = "none",
     .help = "The recording for the guidance replayed-teacher, which requires it.",
     .set = [](const Target& t, const Value& v) { t.condition->teacher = v.text; }},
    {.id = "condition.needs",
     .kind = Kind::kChoice,
     .choices = kDeviceNeeds,
     .fallback = "nothing",
     .help = "What the device must be able to do.",
     .set = [](const Target& t, const Value& v) { t.condition->needs = choice<DeviceNeed>(v); }},
    {.id = "condition.sessions",
     .kind = Kind::kChoices,
     .choices = kSessionKinds,
     .fallback = "all sessions",
     .help = "The sessions that have this condition.",
     .set = [](const Target& t,
               const Value& v) { t.condition->sessions.push_back(choice<SessionKind>(v)); }},
    {.id = "condition.settings",
     .kind = Kind::kSettings,
     .fallback = "none",
     .help = "Options of the tools and of the surface, with their values."},
    {.id = "shape.name",
     .kind = Kind::kId,
     .fallback = "required",
     .help = "The name of the shape, different from the other names.",
     .set = [](const Target& t, const Value& v) { t.shape->name = v.text; }},
    {.id = "shape.kind",
     .kind = Kind::kChoice,
     .choices = kStudyShapeNames,
     .fallback = "required without a file",
     .help = "A built-in shape.",
     .set = [](const Target& t, const Value& v) { t.shape->kind = choice<StudyShapeKind>(v); }},
    {.id = "shape.file",
     .kind = Kind::kFile,
     .fallback = "none",
     .help = "A drawing with the shape, in the folder of the study.",
     .set =
         [](const Target& t, const Value& v) {
           t.shape->kind = StudyShapeKind::kFile;
           t.shape->file = v.text;
         }},
    {.id = "shape.task",
     .kind = Kind::kChoice,
     .choices = kStudyTasks,
     .fallback = "trace",
     .help = "What the participant does with the shape.",
     .set = [](const Target& t, const Value& v) { t.shape->task = choice<StudyTask>(v); }},
    {.id = "shape.size_mm",
     .kind = Kind::kNumber,
     .min = 1,
     .max = 1000,
     .fallback = "80; a file keeps its size",
     .help = "The longer side of the shape's bounding box.",
     .set = [](const Target& t, const Value& v) { t.shape->size_mm = v.number; }},
    {.id = "shape.tunnel_mm",
     .kind = Kind::kNumber,
     .min = 0.1,
     .max = 100,
     .fallback = "none",
     .help = "Width of the tunnel. The task tunnel requires it; other tasks have none.",
     .set = [](const Target& t, const Value& v) { t.shape->tunnel_mm = v.number; }},
    {.id = "shape.width_mm",
     .kind = Kind::kNumber,
     .min = 0.3,
     .max = 6,
     .fallback = "none",
     .help = "Width of the line to draw. The task width requires it; other tasks have none.",
     .set = [](const Target& t, const Value& v) { t.shape->width_mm = v.number; }},
    {.id = "shape.sessions",
     .kind = Kind::kChoices,
     .choices = kSessionKinds,
     .fallback = "all sessions",
     .help = "The sessions that have this shape.",
     .set = [](const Target& t,
               const Value& v) { t.shape->sessions.push_back(choice<SessionKind>(v)); }},
    {.id = "hypothesis.condition",
     .kind = Kind::kId,
     .fallback = "required",
     .help = "The name of the condition about which the hypothesis says something.",
     .set = [](const Target& t, const Value& v) { t.hypothesis->condition = v.text; }},
    {.id = "hypothesis.against",
     .kind = Kind::kId,
     .fallback = "required",
     .help = "The name of the condition with which it is compared.",
     .set = [](const Target& t, const Value& v) { t.hypothesis->against = v.text; }},
    {.id = "hypothesis.measure",
     .kind = Kind::kText,
     .fallback = "required",
     .help = "A metric of `trials.csv` of which less is better, such as err_total_mm.",
     .set = [](const Target& t, const Value& v) { t.hypothesis->measure = v.text; }},
    {.id = "hypothesis.kind",
     .kind = Kind::kChoice,
     .choices = kHypothesisKinds,
     .fallback = "less",
     .help = "What is expected: less than in the other condition, not worse by the margin, or the "
             "same within the margin.",
     .set = [](const Target& t,
               const Value& v) { t.hypothesis->kind = choice<HypothesisKind>(v); }},
    {.id = "hypothesis.margin",
     .kind = Kind::kNumber,
     .min = 0.01,
     .max = 1,
     .fallback = "none",
     .help =
         "A share: with 0.15, 1.15 times as much is worse. The kinds not-worse and same require "
         "it; the kind less has none.",
     .set = [](const Target& t, const Value& v) { t.hypothesis->margin = v.number; }},
    {.id = "hypothesis.session",
     .kind = Kind::kChoice,
     .choices = kSessionKinds,
     .fallback = "the first with both conditions",
     .help = "The session in which it is tested.",
     .set = [](const Target& t,
               const Value& v) { t.hypothesis->session = choice<SessionKind>(v); }},
});

}  // namespace

std::span<const StudyKey> study_keys() noexcept {
  return kKeys;
}

std::string_view study_table_of(std::string_view key) noexcept {
  const std::size_t dot = key.find('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

std::string allowed_text(const StudyKey& key) {
  std::string words;
  for (const std::string_view word : key.choices) {
    words += (words.empty() ? "" : ", ") + std::string(word);
  }
  switch (key.kind) {
    case Kind::kWhole:
      return "a whole number from " + number_text(key.min) + " to " + number_text(key.max);
    case Kind::kNumber:
      return number_text(key.min) + " to " + number_text(key.max);
    case Kind::kSwitch:
      return "true or false";
    case Kind::kId:
      return "1 to 64 of a-z, 0-9 and -";
    case Kind::kText:
      return "1 to 200 bytes of text in one line";
    case Kind::kFile:
      return "the name of a file, without folders";
    case Kind::kChoice:
      return "one of " + words + (key.takes_switch ? ", or false, true" : "");
    case Kind::kChoices:
      return "a list of different values of " + words;
    case Kind::kSettings:
      return "options with numbers, true or false, or texts: \"pencil.stabiliser\" = \"towed\"";
  }
  return "";
}

bool is_study_text(std::string_view text) noexcept {
  return !text.empty() && text.size() <= kMaxStudyTextBytes && is_utf8(text) &&
         std::none_of(text.begin(), text.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) == 0x7F;
         });
}

std::optional<StudyValue> study_value(const StudyKey& key, const TomlEntry& entry) {
  const auto* text = std::get_if<std::string>(&entry.value);
  const auto* number = std::get_if<double>(&entry.value);
  const auto* on = std::get_if<bool>(&entry.value);
  auto choice = text ? std::find(key.choices.begin(), key.choices.end(), *text) : key.choices.end();
  if (on && key.takes_switch) choice = *on ? key.choices.end() - 1 : key.choices.begin();
  bool fits = false;
  switch (key.kind) {
    case StudyKeyKind::kNumber:
      fits = number && *number >= key.min && *number <= key.max;
      break;
    case StudyKeyKind::kWhole:
      fits = number && entry.is_whole && *number >= key.min && *number <= key.max;
      break;
    case StudyKeyKind::kSwitch:
      fits = on != nullptr;
      break;
    case StudyKeyKind::kId:
      fits = text && is_material_id(*text);
      break;
    case StudyKeyKind::kText:
      fits = text && is_study_text(*text);
      break;
    case StudyKeyKind::kFile:
      fits = text && is_file_name(*text);
      break;
    case StudyKeyKind::kChoice:
    case StudyKeyKind::kChoices:
      fits = choice != key.choices.end();
      break;
    case StudyKeyKind::kSettings:
      break;
  }
  if (!fits) return std::nullopt;
  return StudyValue{number ? *number : 0.0, on && *on, text ? *text : std::string(),
                    static_cast<std::size_t>(choice - key.choices.begin())};
}

}  // namespace felt
