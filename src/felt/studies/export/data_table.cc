#include "felt/studies/export/data_table.h"

#include <array>
#include <charconv>
#include <set>

#include "felt/base/hash.h"
#include "felt/geometry/polyline.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/trial/trial_columns.h"

namespace felt {
namespace {

using TrialColumns = std::vector<DataColumn<MeasuredTrial>>;

std::string text_of(bool value) {
  return value ? "true" : "false";
}

std::string number_or_empty(const std::optional<double>& value) {
  return value ? json_number(*value) : "";
}

std::string setting_text(const StudySetting& setting) {
  if (const auto* number = std::get_if<double>(&setting.value)) return json_number(*number);
  if (const auto* is_on = std::get_if<bool>(&setting.value)) return *is_on ? "on" : "off";
  return std::get<std::string>(setting.value);
}

/// Returns the value of an option in a condition; empty if the condition does not set it.
std::string option_text(const StudyCondition& condition, const std::string& option) {
  for (const StudySetting& setting : condition.settings) {
    if (setting.id == option) return setting_text(setting);
  }
  return "";
}

std::vector<std::pair<std::string, std::string>> condition_levels(const Study& study) {
  std::vector<std::pair<std::string, std::string>> levels;
  for (const StudyCondition& condition : study.conditions) {
    levels.emplace_back(condition.name, condition.label);
  }
  return levels;
}

template <std::size_t kCount>
std::vector<std::pair<std::string, std::string>> levels_of(
    const std::array<std::string_view, kCount>& names,
    const std::array<std::string_view, kCount>& meanings) {
  std::vector<std::pair<std::string, std::string>> levels;
  for (std::size_t i = 0; i < kCount; ++i) levels.emplace_back(names[i], meanings[i]);
  return levels;
}

constexpr std::array<std::string_view, 9> kTaskMeanings = {
    "draw along a visible line",
    "draw between two walls",
    "draw freely beside a model",
    "draw from target to target",
    "find an engraved line by touch",
    "draw over a line of ink",
    "draw along a closed line, so that the end meets the start",
    "draw along a line, as broad as required",
    "erase the part of a line between two lines that cross it"};
constexpr std::array<std::string_view, 3> kForcesMeanings = {
    "none, and no surface", "only the plane of the surface", "those of the program"};
constexpr std::array<std::string_view, 5> kGuidanceMeanings = {
    "no guidance", "a groove along the line",
    "a force that grows with the error and fades as the participant improves",
    "a force away from the line", "the recorded pen of a teacher leads the hand"};
constexpr std::array<std::string_view, 5> kSessionMeanings = {
    "before training", "training", "directly after training", "after a delay",
    "with other shapes or conditions than in training"};

/// Adds the columns that say which trial a row is.
void add_order_columns(const StudyResults& results, TrialColumns& columns) {
  columns.push_back({{"participant", "Number of the participant.", "1"},
                     [](const auto& t) { return std::to_string(t.info.participant); }});
  columns.push_back(
      {{"session", "Session of the study.", "", "", levels_of(kSessionKinds, kSessionMeanings)},
       [](const auto& t) {
         return std::string(kSessionKinds[static_cast<std::size_t>(t.plan.session)]);
       }});
  columns.push_back({{"block", "Block of the session, from 1; 0 for practice trials.", "1"},
                     [](const auto& t) { return std::to_string(t.plan.block); }});
  columns.push_back({{"trial", "Number of the trial in the session, in its order, from 1.", "1"},
                     [](const auto& t) { return std::to_string(t.plan.number); }});
  columns.push_back({{"attempt", "1, or more if the trial was repeated.", "1"},
                     [](const auto& t) { return std::to_string(t.result.attempt); }});
  columns.push_back(
      {{"condition", "Condition of the study.", "", "", condition_levels(results.files.study)},
       [&results](const auto& t) { return results.condition_of(t.plan).name; }});
  columns.push_back(
      {{"position", "Position of the condition in its block, from 1; 0 for practice trials.", "1"},
       [](const auto& t) { return std::to_string(t.position); }});
  columns.push_back(
      {{"repetition", "Repetition of the shape in this condition and block, from 1.", "1"},
       [](const auto& t) { return std::to_string(t.plan.repetition); }});
  columns.push_back({{"is_practice", "true for practice trials."},
                     [](const auto& t) { return text_of(t.plan.is_practice); }});
}

/// Adds the columns that say how the conditions differ: their properties and their settings.
void add_factor_columns(const StudyResults& results, TrialColumns& columns) {
  columns.push_back({{"forces", "The forces of this condition.", "", "",
                      levels_of(kStudyForces, kForcesMeanings)},
                     [&results](const auto& t) {
                       const auto forces = results.condition_of(t.plan).forces;
                       return std::string(kStudyForces[static_cast<std::size_t>(forces)]);
                     }});
  columns.push_back(
      {{"vision", "true if the participant sees the drawing."},
       [&results](const auto& t) { return text_of(results.condition_of(t.plan).has_vision); }});
  columns.push_back({{"guidance", "How forces guide the pen along the shape.", "", "",
                      levels_of(kStudyGuidances, kGuidanceMeanings)},
                     [&results](const auto& t) {
                       const auto guidance = results.condition_of(t.plan).guidance;
                       return std::string(kStudyGuidances[static_cast<std::size_t>(guidance)]);
                     }});
  columns.push_back(
      {{"guidance_strength", "Strength of the guidance, 0 to 1; empty without guidance.", "1"},
       [&results](const auto& t) {
         const StudyCondition& condition = results.condition_of(t.plan);
         if (condition.guidance == StudyGuidance::kNone) return std::string();
         return json_number(condition.strength);
       }});
  std::set<std::string> options;
  for (const StudyCondition& condition : results.files.study.conditions) {
    for (const StudySetting& setting : condition.settings) options.insert(setting.id);
  }
  for (const std::string& option : options) {
    columns.push_back({{option, "Option of the program; empty if the condition does not set it."},
                       [&results, option](const auto& t) {
                         return option_text(results.condition_of(t.plan), option);
                       }});
  }
}

/// Adds the columns that say what was drawn and with what.
void add_setup_columns(const StudyResults& results, TrialColumns& columns) {
  columns.push_back({{"shape", "Shape that the participant draws."},
                     [&results](const auto& t) { return results.shape_of(t.plan).name; }});
  columns.push_back({{"task", "What the participant does with the shape.", "", "",
                      levels_of(kStudyTasks, kTaskMeanings)},
                     [&results](const auto& t) {
                       const auto task = results.shape_of(t.plan).task;
                       return std::string(kStudyTasks[static_cast<std::size_t>(task)]);
                     }});
  columns.push_back(
      {{"shape_length_mm", "Length of the path of the shape.", "mm"}, [&results](const auto& t) {
         const StudyPath& path = results.files.paths[t.plan.shape];
         double length = polyline_length(path.points);
         if (path.ends == TrialPathEnds::kClosed && !path.points.empty()) {
           length += distance(path.points.back(), path.points.front());
         }
         return json_number(length);
       }});
  columns.push_back({{"shape_tunnel_mm", "Width of the tunnel; empty without a tunnel.", "mm"},
                     [&results](const auto& t) {
                       const double width = results.shape_of(t.plan).tunnel_mm;
                       return width > 0.0 ? json_number(width) : std::string();
                     }});
  columns.push_back(
      {{"seed", "Seed of everything random in the trial; a whole number of up to 64 bits.", "1"},
       [](const auto& t) { return std::to_string(t.plan.seed); }});
  columns.push_back({{"device", "Device with which the participant drew."},
                     [](const auto& t) { return t.info.device; }});
  columns.push_back({{"program", "Program that ran the session, with its version."},
                     [](const auto& t) { return t.info.program; }});
  columns.push_back({{"started", "Start of the session in UTC; empty for a simulated person."},
                     [](const auto& t) { return t.info.started; }});
  columns.push_back({{"person_seed", "Seed of the simulated person; empty for a real person.", "1"},
                     [](const auto& t) {
                       return t.info.person_seed ? std::to_string(*t.info.person_seed)
                                                 : std::string();
                     }});
  columns.push_back({{"person_model", "Model of the simulated person; empty for a real person."},
                     [](const auto& t) { return t.info.person_model; }});
  columns.push_back(
      {{"study_hash", "Fingerprint (FNV-1a) of the study file and of the files that it names."},
       [hash = study_hash(results.files)](const auto&) { return hash; }});
}

std::string question_item(const GivenAnswers& answers, Questionnaire form, std::size_t item) {
  if (answers.answers.form != form || item >= answers.answers.values.size()) return "";
  return json_number(answers.answers.values[item]);
}

constexpr const char* kTlxSource = "10.1177/154193120605000909";
constexpr const char* kUeqSource = "10.9781/ijimai.2017.09.001";

void add_question_items(std::vector<DataColumn<GivenAnswers>>& columns) {
  static constexpr std::array<std::array<const char*, 2>, 6> kTlxItems = {
      {{"tlx_mental", "Mental demand"},
       {"tlx_physical", "Physical demand"},
       {"tlx_temporal", "Temporal demand"},
       {"tlx_performance", "Performance; perfect is 0, failure 100"},
       {"tlx_effort", "Effort"},
       {"tlx_frustration", "Frustration"}}};
  for (std::size_t i = 0; i < kTlxItems.size(); ++i) {
    columns.push_back(
        {{kTlxItems[i][0], std::string(kTlxItems[i][1]) + " (NASA-TLX), 0 to 100.", "1",
          "10.1016/S0166-4115(08)62386-9"},
         [i](const auto& a) { return question_item(a, Questionnaire::kNasaTlx, i); }});
  }
  static constexpr std::array<const char*, 8> kUeqItems = {
      "obstructive - supportive", "complicated - easy",  "inefficient - efficient",
      "confusing - clear",        "boring - exciting",   "not interesting - interesting",
      "conventional - inventive", "usual - leading edge"};
  for (std::size_t i = 0; i < kUeqItems.size(); ++i) {
    columns.push_back({{"ueq_" + std::to_string(i + 1),
                        std::string(kUeqItems[i]) + " (UEQ-S), 1 to 7.", "1", kUeqSource},
                       [i](const auto& a) { return question_item(a, Questionnaire::kUeqS, i); }});
  }
}

}  // namespace

std::string study_hash(const StudyFiles& files) {
  Fnv1a hash;
  for (const auto& [name, bytes] : files.sources) {
    for (const std::string& text : {name, bytes}) {
      hash.add(std::as_bytes(std::span(text)));
      hash.add_value(static_cast<std::uint64_t>(text.size()));
    }
  }
  std::array<char, 17> digits{};
  auto* const end =
      std::to_chars(digits.data(), digits.data() + digits.size(), hash.value(), 16).ptr;
  const std::string text(digits.data(), end);
  return "fnv1a-" + std::string(16 - text.size(), '0') + text;
}

std::vector<DataColumn<MeasuredTrial>> trial_columns(const StudyResults& results) {
  TrialColumns columns;
  add_order_columns(results, columns);
  add_factor_columns(results, columns);
  add_setup_columns(results, columns);
  columns.push_back({{"valid", "false if the trial broke a catch rule or was interrupted."},
                     [](const auto& t) { return text_of(t.result.invalid.empty()); }});
  columns.push_back({{"reason",
                      "Why the trial is invalid: the name of the catch rule, or "
                      "interrupted; empty for a valid trial."},
                     [](const auto& t) { return t.result.invalid; }});
  columns.push_back({{"recording", "Recording of the trial, in the folder of this table."},
                     [](const auto& t) { return t.recording; }});
  for (const TrialColumn& metric : trial_metric_columns()) {
    columns.push_back(
        {{std::string(metric.name), std::string(metric.formula), std::string(metric.unit),
          std::string(metric.source)},
         [value = metric.value](const auto& t) { return number_or_empty(t.metrics.*value); }});
  }
  return columns;
}

std::vector<DataColumn<GivenAnswers>> answer_columns(const StudyResults& results) {
  std::vector<DataColumn<GivenAnswers>> columns;
  columns.push_back({{"participant", "Number of the participant.", "1"},
                     [](const auto& a) { return std::to_string(a.info.participant); }});
  columns.push_back(
      {{"session", "Session of the study.", "", "", levels_of(kSessionKinds, kSessionMeanings)},
       [](const auto& a) {
         return std::string(kSessionKinds[static_cast<std::size_t>(a.plan.session)]);
       }});
  columns.push_back({{"after_trial", "Number of the trial after which the questions came.", "1"},
                     [](const auto& a) { return std::to_string(a.answers.after_trial); }});
  columns.push_back(
      {{"condition", "Condition of this trial.", "", "", condition_levels(results.files.study)},
       [&results](const auto& a) { return results.condition_of(a.plan).name; }});
  columns.push_back({{"form",
                      "Questionnaire.",
                      "",
                      "",
                      {{"nasa-tlx", "NASA Task Load Index without weights"},
                       {"ueq-s", "User Experience Questionnaire, short"}}},
                     [](const auto& a) {
                       return std::string(
                           kQuestionnaires[static_cast<std::size_t>(a.answers.form)]);
                     }});
  add_question_items(columns);
  columns.push_back({{"tlx_mean", "Raw TLX: mean of the six scales.", "1", kTlxSource},
                     [](const auto& a) { return number_or_empty(scores_of(a.answers).tlx_mean); }});
  columns.push_back(
      {{"ueq_pragmatic", "Pragmatic quality: mean of items 1 to 4, minus 4; -3 to 3.", "1",
        kUeqSource},
       [](const auto& a) { return number_or_empty(scores_of(a.answers).ueq_pragmatic); }});
  columns.push_back(
      {{"ueq_hedonic", "Hedonic quality: mean of items 5 to 8, minus 4; -3 to 3.", "1", kUeqSource},
       [](const auto& a) { return number_or_empty(scores_of(a.answers).ueq_hedonic); }});
  columns.push_back(
      {{"ueq_overall", "Overall: mean of all items, minus 4; -3 to 3.", "1", kUeqSource},
       [](const auto& a) { return number_or_empty(scores_of(a.answers).ueq_overall); }});
  return columns;
}

namespace {

std::string info_text(const ColumnInfo& column) {
  JsonObject object;
  object.add_text("Description", column.description);
  if (!column.unit.empty()) object.add_text("Units", column.unit);
  std::string levels;
  for (const auto& [value, meaning] : column.levels) {
    levels += (levels.empty() ? "{" : ",") + json_string(spreadsheet_text(value)) + ":" +
              json_string(meaning);
  }
  if (!levels.empty()) object.add_raw("Levels", levels + "}");
  if (!column.source.empty()) object.add_text("TermURL", "https://doi.org/" + column.source);
  return object.text();
}

}  // namespace

std::string dictionary_text(std::span<const ColumnInfo> columns) {
  std::string out = "{";
  for (const ColumnInfo& column : columns) {
    out += (out.size() > 1 ? ",\n" : "\n") + json_string(column.name) + ": " + info_text(column);
  }
  return out + "\n}\n";
}

}  // namespace felt
