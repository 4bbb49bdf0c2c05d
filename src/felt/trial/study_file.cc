#include "felt/trial/study_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "felt/base/printable.h"
#include "felt/material/material_file.h"
#include "felt/material/toml_entries.h"
#include "felt/trial/study_hypothesis.h"
#include "felt/trial/study_keys.h"
#include "felt/trial/study_order.h"

namespace felt {
namespace {

constexpr std::string_view kSettingsKey = "condition.settings";
constexpr const char* kSettingsAllowed = "a table of options and their values";
constexpr const char* kSettingAllowed =
    "a finite number, true, false, or 1 to 200 bytes of text in one line";

/// Returns true for "pencil.stabiliser": two words of a-z, 0-9 and '_' with a dot between them.
bool is_setting_id(std::string_view id) noexcept {
  const std::size_t dot = id.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == id.size()) return false;
  return std::all_of(id.begin(), id.end(),
                     [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
                              c == '.';
                     }) &&
         id.find('.', dot + 1) == std::string_view::npos;
}

bool is_list_of_tables(std::string_view table) noexcept {
  return table == "condition" || table == "shape" || table == "hypothesis";
}

/// Returns true for an empty table such as [rest], which is allowed.
bool is_empty_table(const TomlEntry& entry) noexcept {
  const auto* other = std::get_if<TomlOther>(&entry.value);
  return other && other->what == kTomlEmptyTable;
}

/// Reads entries into a study and collects the problems.
class StudyReading {
 public:
  StudyReading(const std::string& name, const std::vector<TomlEntry>& entries)
      : name_(name), entries_(entries) {}

  Study study() {
    make_tables("condition", kMaxStudyConditions, study_.conditions);
    make_tables("shape", kMaxStudyShapes, study_.shapes);
    make_tables("hypothesis", kMaxStudyHypotheses, study_.hypotheses);
    if (find("sessions")) study_.sessions.clear();
    for (const TomlEntry& entry : entries_) read(entry);
    check_study();
    // Parts without a line are not tables; read() has reported them.
    for (std::size_t i = 0; i < study_.conditions.size(); ++i) {
      if (study_.conditions[i].line > 0) check_condition(i);
    }
    for (std::size_t i = 0; i < study_.shapes.size(); ++i) {
      if (study_.shapes[i].line > 0) check_shape(i);
    }
    check_rules();
    check_sessions();
    check_hypotheses(
        study_, entries_,
        [this](std::string_view key, std::size_t table) { return is_refused(key, table); },
        [this](int line, const std::string& what) { say(line, what); });
    return std::move(study_);
  }

  /// Returns the problems in the order of the text.
  std::vector<Error> problems() && {
    std::stable_sort(problems_.begin(), problems_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Error> errors;
    for (auto& [line, error] : problems_) {
      if (errors.size() < kMaxStudyProblems) errors.push_back(std::move(error));
    }
    return errors;
  }

 private:
  /// The index of the tables that are not in a list: TomlEntry::table is -1.
  static constexpr auto kNoTable = static_cast<std::size_t>(-1);

  [[nodiscard]] const TomlEntry* find(std::string_view key, std::size_t table) const {
    const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const TomlEntry& entry) {
      return entry.key == key && entry.table == static_cast<int>(table);
    });
    return at == entries_.end() ? nullptr : &*at;
  }
  [[nodiscard]] const TomlEntry* find(std::string_view key) const { return find(key, kNoTable); }

  void say(int line, const std::string& what) {
    problems_.push_back({line, {ErrorCode::kInvalidData, toml_place(name_, line) + what}});
  }
  void refuse(const TomlEntry& entry, const std::string& allowed) {
    refused_.emplace(entry.key, entry.table);
    say(entry.line, printable(entry.key) + " is " + printable(toml_value_text(entry)) +
                        ", it must be " + allowed);
  }
  /// Returns true if the value of this key was refused, so that what depends on it is not checked.
  [[nodiscard]] bool is_refused(std::string_view key, std::size_t table) const {
    return refused_.contains({std::string(key), static_cast<int>(table)});
  }

  /// Reports a problem only the first time that `subject` has it.
  void say_once(const std::string& subject, int line, const std::string& what) {
    if (said_.insert(subject).second) say(line, what);
  }

  /// Adds a condition, shape or hypothesis for each table of the list `name`.
  template <class Part>
  void make_tables(std::string_view name, std::size_t max, std::vector<Part>& parts) {
    for (const TomlEntry& entry : entries_) {
      if (entry.table < 0 || entry.key.substr(0, entry.key.find('.')) != name) continue;
      const auto index = static_cast<std::size_t>(entry.table);
      if (index >= max) {
        return say(entry.line,
                   std::string(name) + ": a study has at most " + std::to_string(max) + " of them");
      }
      if (index >= parts.size()) parts.resize(index + 1);
      if (parts[index].line == 0) parts[index].line = entry.line;
    }
  }

  /// Returns a part, or null for tables beyond the limit, which make_tables reports.
  template <class Part>
  static Part* part_at(std::vector<Part>& parts, std::size_t index) {
    return index < parts.size() ? &parts[index] : nullptr;
  }

  void read(const TomlEntry& entry) {
    const std::string table = entry.key.substr(0, entry.key.find('.'));
    if (is_list_of_tables(table)) {
      if (entry.table < 0) {
        return say_once(table, entry.line, table + " must be written as [[" + table + "]]");
      }
      if (entry.key == table) return;  // an empty table: its name is missing
      const auto index = static_cast<std::size_t>(entry.table);
      const StudyTarget target{&study_,
                               table == "condition" ? part_at(study_.conditions, index) : nullptr,
                               table == "shape" ? part_at(study_.shapes, index) : nullptr,
                               table == "hypothesis" ? part_at(study_.hypotheses, index) : nullptr};
      if (target.condition || target.shape || target.hypothesis) read_value(entry, target);
      return;
    }
    const bool is_table =
        std::any_of(study_keys().begin(), study_keys().end(),
                    [&table](const StudyKey& key) { return study_table_of(key.id) == table; });
    if (!table.empty() && is_table && entry.table >= 0) {
      return say_once(table, entry.line, table + " must be written as [" + table + "]");
    }
    if (is_table && entry.key == table && is_empty_table(entry)) return;
    read_value(entry, {&study_});
  }

  void read_value(const TomlEntry& entry, const StudyTarget& target) {
    if (entry.key == kSettingsKey || entry.key.starts_with(std::string(kSettingsKey) + ".")) {
      return read_setting(entry, *target.condition);
    }
    const auto key = std::find_if(study_keys().begin(), study_keys().end(),
                                  [&entry](const StudyKey& k) { return k.id == entry.key; });
    if (key == study_keys().end()) return unknown(entry);
    const bool is_list = entry.item >= 0;
    if (is_list != (key->kind == StudyKeyKind::kChoices)) {
      if (!is_list) return refuse(entry, allowed_text(*key));
      if (entry.item == 0)
        say(entry.line, entry.key + " is a list, it must be " + allowed_text(*key));
      return;
    }
    const std::optional<StudyValue> value = study_value(*key, entry);
    if (!value && is_list) {
      refused_.emplace(entry.key, entry.table);
      return say(entry.line, entry.key + " has " + printable(toml_value_text(entry)) +
                                 ", it must be " + allowed_text(*key));
    }
    if (!value) return refuse(entry, allowed_text(*key));
    if (is_list && !listed_.emplace(entry.key, entry.table, value->choice).second) {
      return say(entry.line, entry.key + " has " + toml_value_text(entry) + " twice");
    }
    key->set(target, *value);
  }

  void read_setting(const TomlEntry& entry, StudyCondition& condition) {
    if (entry.item >= 0) {
      if (entry.item > 0) return;  // reported with the first value of the list
      return say(entry.line, printable(entry.key) + " is a list, it must be " +
                                 (entry.key == kSettingsKey ? kSettingsAllowed : kSettingAllowed));
    }
    if (entry.key == kSettingsKey) {
      if (!is_empty_table(entry)) refuse(entry, kSettingsAllowed);
      return;
    }
    std::string id = entry.key.substr(kSettingsKey.size() + 1);
    if (id.size() > 2 && id.front() == '"' && id.back() == '"') id = id.substr(1, id.size() - 2);
    if (!is_setting_id(id)) {
      return say(entry.line, printable(entry.key) +
                                 ": the keys of condition.settings must be options such as "
                                 "\"pencil.stabiliser\"");
    }
    const auto* number = std::get_if<double>(&entry.value);
    const auto* text = std::get_if<std::string>(&entry.value);
    const auto* on = std::get_if<bool>(&entry.value);
    if (!((number && std::isfinite(*number)) || on || (text && is_study_text(*text)))) {
      return refuse(entry, kSettingAllowed);
    }
    const bool is_twice = std::any_of(condition.settings.begin(), condition.settings.end(),
                                      [&id](const StudySetting& s) { return s.id == id; });
    if (is_twice) return say(entry.line, "condition.settings has " + id + " twice");
    if (condition.settings.size() == kMaxConditionSettings) {
      return say_once(
          "settings", entry.line,
          "condition.settings has more than " + std::to_string(kMaxConditionSettings) + " options");
    }
    StudySetting setting{id, false, entry.line};
    if (number) setting.value = *number;
    if (text) setting.value = *text;
    if (on) setting.value = *on;
    condition.settings.push_back(std::move(setting));
  }

  void unknown(const TomlEntry& entry) {
    const std::string_view table = study_table_of(entry.key);
    std::string known, tables;
    for (const StudyKey& key : study_keys()) {
      const std::string_view in = study_table_of(key.id);
      if (in == table) {
        known += (known.empty() ? "" : ", ") +
                 std::string(key.id.substr(in.empty() ? 0 : in.size() + 1));
      }
    }
    if (!known.empty() && !table.empty()) {
      const std::string header = is_list_of_tables(table) ? "[[" + std::string(table) + "]]"
                                                          : "[" + std::string(table) + "]";
      return say(entry.line, printable(entry.key) + " is unknown; " + header + " has " + known);
    }
    known.clear();
    for (const StudyKey& key : study_keys()) {
      const std::string in(study_table_of(key.id));
      const std::string shown = in.empty()              ? std::string(key.id)
                                : is_list_of_tables(in) ? "[[" + in + "]]"
                                                        : "[" + in + "]";
      if (!(known + ", ").ends_with(", " + shown + ", ")) {
        known += (known.empty() ? "" : ", ") + shown;
      }
    }
    say(entry.line, printable(entry.key) + " is unknown; a study has " + known);
  }

  void check_study() {
    if (!find("id")) say(1, "id is missing; it must be 1 to 64 of a-z, 0-9 and -");
    if (study_.label.empty()) study_.label = label_of_id(study_.id);
    if (study_.conditions.empty() && !said_.contains("condition")) {
      say(1, "condition is missing; a study has 1 to " + std::to_string(kMaxStudyConditions) +
                 " tables [[condition]]");
    }
    if (study_.shapes.empty() && !said_.contains("shape")) {
      say(1, "shape is missing; a study has 1 to " + std::to_string(kMaxStudyShapes) +
                 " tables [[shape]]");
    }
  }

  template <class Part>
  void check_name(const std::string& table, const std::vector<Part>& parts, std::size_t index) {
    const TomlEntry* entry = find(table + ".name", index);
    const Part& part = parts[index];
    if (!entry) {
      return say(part.line, table + ".name is missing; it must be 1 to 64 of a-z, 0-9 and -");
    }
    const auto same = std::find_if(parts.begin(), parts.end(), [&part](const Part& other) {
      return other.name == part.name && !part.name.empty();
    });
    if (same != parts.end() && &*same != &part) {
      say(entry->line, table + ".name is \"" + part.name +
                           "\", it must be different from the name in line " +
                           std::to_string(same->line));
    }
  }

  void check_part_sessions(const std::string& key, std::size_t index) {
    for (const TomlEntry& entry : entries_) {
      const auto* text = std::get_if<std::string>(&entry.value);
      if (entry.key != key || entry.table != static_cast<int>(index) || !text) continue;
      const auto kind = std::find(kSessionKinds.begin(), kSessionKinds.end(), *text);
      if (kind == kSessionKinds.end() || study_.sessions.empty()) continue;
      const auto session = static_cast<SessionKind>(kind - kSessionKinds.begin());
      if (std::find(study_.sessions.begin(), study_.sessions.end(), session) ==
          study_.sessions.end()) {
        refuse(entry, "in sessions of the study");
        are_sessions_refused_ = true;
      }
    }
  }

  void check_condition(std::size_t index) {
    StudyCondition& condition = study_.conditions[index];
    check_name("condition", study_.conditions, index);
    check_part_sessions("condition.sessions", index);
    if (condition.label.empty()) condition.label = label_of_id(condition.name);
    if (is_refused("condition.guidance", index)) return;
    const TomlEntry* guidance = find("condition.guidance", index);
    const TomlEntry* teacher = find("condition.teacher", index);
    const bool is_replayed = condition.guidance == StudyGuidance::kReplayedTeacher;
    if (is_replayed && !teacher) {
      say(guidance->line,
          "condition.teacher is missing; the guidance replayed-teacher requires the name of a "
          "file");
    } else if (teacher && !is_replayed) {
      say(teacher->line, "condition.teacher has no effect without the guidance replayed-teacher");
    }
    if (condition.guidance == StudyGuidance::kNone) {
      if (const TomlEntry* strength = find("condition.strength", index)) {
        say(strength->line, "condition.strength has no effect without condition.guidance");
      }
    } else if (condition.forces != StudyForces::kAll) {
      const TomlEntry* forces = find("condition.forces", index);
      say(forces->line, "condition.forces is " + toml_value_text(*forces) +
                            ", it must be \"all\" for the guidance " + toml_value_text(*guidance));
    }
  }

  void check_shape(std::size_t index) {
    const StudyShape& shape = study_.shapes[index];
    check_name("shape", study_.shapes, index);
    check_part_sessions("shape.sessions", index);
    const TomlEntry* file = find("shape.file", index);
    const TomlEntry* kind = find("shape.kind", index);
    if (file && kind) {
      say(std::max(file->line, kind->line), "shape has a kind and a file, only one is allowed");
    } else if (!file && !kind) {
      say(shape.line, "shape.kind is missing; it must be " + shape_kinds() +
                          ", or shape.file must name a file");
    }
    if (is_refused("shape.task", index)) return;
    check_task_key(index, "shape.tunnel_mm", StudyTask::kTunnel, "0.1 to 100");
    check_task_key(index, "shape.width_mm", StudyTask::kWidth, "0.3 to 6");
    check_task_shape(index);
  }

  /// Reports `key` if it is missing for the only task that has it, or present for another task.
  void check_task_key(std::size_t index, std::string_view key, StudyTask task,
                      const std::string& allowed) {
    const std::string name(kStudyTasks[static_cast<std::size_t>(task)]);
    const TomlEntry* entry = find(key, index);
    const bool is_used = study_.shapes[index].task == task;
    if (is_used && !entry) {
      say(find("shape.task", index)->line,
          std::string(key) + " is missing; the task " + name + " requires it, " + allowed);
    } else if (entry && !is_used) {
      say(entry->line, std::string(key) + " has no effect without the task " + name);
    }
  }

  /// Checks that the built-in shape suits the task. The line of a file is checked when it is read.
  void check_task_shape(std::size_t index) {
    const StudyShape& shape = study_.shapes[index];
    const TomlEntry* task = find("shape.task", index);
    const TomlEntry* kind = find("shape.kind", index);
    if (is_refused("shape.kind", index)) return;
    const bool is_closed =
        shape.kind == StudyShapeKind::kCircle || shape.kind == StudyShapeKind::kStar;
    if (shape.task == StudyTask::kClose && kind && !is_closed) {
      say(kind->line, "shape.kind is " + toml_value_text(*kind) +
                          ", it must be \"circle\" or \"star\" for the task close");
    }
    if (shape.task != StudyTask::kErase) return;
    if (shape.kind != StudyShapeKind::kLine) {
      say((kind ? kind : task)->line, "shape.kind must be \"line\" for the task erase");
    }
    const TomlEntry* size = find("shape.size_mm", index);
    if (!size || !shape.size_mm) return;
    if (*shape.size_mm < kMinErasedLineMm || *shape.size_mm > kMaxErasedLineMm) {
      say(size->line, "shape.size_mm is " + toml_value_text(*size) +
                          ", it must be 50 to 250 for the task erase");
    }
  }

  static std::string shape_kinds() {
    const auto key = std::find_if(study_keys().begin(), study_keys().end(),
                                  [](const StudyKey& k) { return k.id == "shape.kind"; });
    return allowed_text(*key);
  }

  /// Reports `key` if it is present although `decider` makes it useless.
  void check_useless(std::string_view key, bool is_useful, std::string_view decider,
                     const std::string& without) {
    const TomlEntry* entry = find(key);
    if (!entry || is_useful || is_refused(decider, kNoTable)) return;
    say(entry->line, std::string(key) + " has no effect without " + without);
  }

  void check_rules() {
    const CatchRules& rules = study_.catch_rules;
    const bool has_tunnel =
        std::any_of(study_.shapes.begin(), study_.shapes.end(),
                    [](const StudyShape& s) { return s.task == StudyTask::kTunnel; });
    const bool has_rule = rules.min_length_share > 0.0 || find("catch.min_length_share") ||
                          find("catch.max_lifts") || find("catch.max_mm_per_s") ||
                          rules.left_tunnel || rules.device_fault;
    check_useless("rest.after_trials", study_.rest_s > 0.0, "rest.seconds", "rest.seconds above 0");
    check_useless("catch.left_tunnel", has_tunnel, "", "a shape with the task tunnel");
    check_useless("catch.action", has_rule, "", "a catch rule");
    check_useless("catch.max_repeats", rules.action == CatchAction::kRepeat, "catch.action",
                  "catch.action = \"repeat\"");
    check_useless("questions.after", find("questions.forms") != nullptr, "", "questions.forms");
  }

  /// Checks that each session has trials, but not too many.
  void check_sessions() {
    const bool is_refused_before = are_sessions_refused_ || is_refused("sessions", kNoTable);
    if (study_.conditions.empty() || study_.shapes.empty() || is_refused_before) return;
    for (const SessionKind session : study_.sessions) {
      const std::string name =
          "\"" + std::string(kSessionKinds[static_cast<std::size_t>(session)]) + "\"";
      const TomlEntry* entry = find("sessions");
      const int line = entry ? entry->line : 1;
      const std::size_t count = trial_count(study_, session);
      if (conditions_in(study_, session).empty()) {
        say(line, "sessions: " + name + " has no condition");
      } else if (shapes_in(study_, session).empty()) {
        say(line, "sessions: " + name + " has no shape");
      } else if (count > kMaxSessionTrials) {
        for (const char* key : {"practice_trials", "repetitions", "blocks"}) {
          if (const TomlEntry* factor = find(key)) entry = factor;
        }
        const std::string key = entry ? entry->key : "sessions";
        say_once("trials", entry ? entry->line : 1,
                 key + ": session " + name + " has " + std::to_string(count) +
                     " trials, it must have at most " + std::to_string(kMaxSessionTrials));
      }
    }
  }

  const std::string& name_;
  const std::vector<TomlEntry>& entries_;
  Study study_;
  std::set<std::string> said_;
  std::set<std::pair<std::string, int>> refused_;
  bool are_sessions_refused_ = false;
  std::set<std::tuple<std::string, int, std::size_t>> listed_;
  std::vector<std::pair<int, Error>> problems_;
};

std::optional<Study> read_any_study(std::string_view text, const std::string& name,
                                    std::vector<Error>& problems) {
  if (std::optional<Error> error = toml_too_long(text, name, kMaxStudyBytes)) {
    problems.push_back(*std::move(error));
    return std::nullopt;
  }
  const Result<std::vector<TomlEntry>> entries =
      read_toml(text, name, {TomlRules::Lists::kItems, "a study"});
  if (!entries) {
    problems.push_back(entries.error());
    return std::nullopt;
  }
  StudyReading reading(name, *entries);
  Study study = reading.study();
  problems = std::move(reading).problems();
  return study;
}

}  // namespace

Result<Study> read_study(std::string_view text, const std::string& name) {
  std::vector<Error> problems;
  std::optional<Study> study = read_any_study(text, name, problems);
  if (!problems.empty()) return tl::unexpected(problems.front());
  return *std::move(study);
}

std::vector<Error> study_problems(std::string_view text, const std::string& name) {
  std::vector<Error> problems;
  read_any_study(text, name, problems);
  return problems;
}

}  // namespace felt
