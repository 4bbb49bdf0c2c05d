#include "felt/studies/session_file.h"

#include <simdjson.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <span>
#include <utility>

#include "felt/base/printable.h"
#include "felt/devices/simulated/person.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/studies/measured_trial.h"

namespace felt {
namespace {

namespace dom = simdjson::dom;

constexpr std::string_view kFormat = "feltline-study-session";
constexpr std::size_t kMaxTextBytes = 200;

std::string_view form_name(Questionnaire form) {
  return kQuestionnaires[static_cast<std::size_t>(form)];
}

bool is_line(std::string_view text) {
  return text.size() <= kMaxTextBytes && printable(text) == text;
}

/// Returns true for a time that exists, such as "2026-11-24T09:30:00Z", and for an empty text.
bool is_start(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  if (text.empty()) return true;
  const bool has_form =
      std::equal(text.begin(), text.end(), kForm.begin(), kForm.end(),
                 [](char c, char form) { return form == '0' ? c >= '0' && c <= '9' : c == form; });
  if (!has_form) return false;
  const auto two_digits = [&text](std::size_t at) {
    return static_cast<unsigned>((text[at] - '0') * 10 + (text[at + 1] - '0'));
  };
  const std::chrono::year_month_day date(
      std::chrono::year(static_cast<int>(two_digits(0) * 100 + two_digits(2))),
      std::chrono::month(two_digits(5)), std::chrono::day(two_digits(8)));
  return date.ok() && two_digits(11) < 24 && two_digits(14) < 60 && two_digits(17) < 60;
}

bool is_fingerprint(std::string_view text) {
  constexpr std::string_view kStart = "fnv1a-";
  return text.starts_with(kStart) && text.size() == kStart.size() + 16 &&
         text.find_first_not_of("0123456789abcdef", kStart.size()) == std::string_view::npos;
}

bool is_known_reason(std::string_view invalid) {
  return invalid.empty() || invalid == kInterrupted ||
         std::find(kCatchRuleNames.begin(), kCatchRuleNames.end(), invalid) !=
             kCatchRuleNames.end();
}

Result<void> check_info(const SessionInfo& info) {
  if (!is_line(info.device)) return invalid_data("device: not one line of at most 200 bytes");
  if (!is_line(info.program)) return invalid_data("program: not one line of at most 200 bytes");
  if (!is_start(info.started)) {
    return invalid_data("started: \"" + printable(info.started) +
                        "\" is not a time such as 2026-11-24T09:30:00Z");
  }
  return {};
}

/// Checks the trials in their order.
Result<void> check_results(const StudySession& session) {
  std::set<std::pair<int, int>> seen;
  for (std::size_t i = 0; i < session.results.size(); ++i) {
    const TrialResult& result = session.results[i];
    const std::string place = "trials[" + std::to_string(i) + "]: ";
    const std::string trial = "trial " + std::to_string(result.trial);
    if (result.trial < 1 || static_cast<std::size_t>(result.trial) > session.plan.size()) {
      return invalid_data(place + trial + " is not planned; the session has " +
                          std::to_string(session.plan.size()) + " trials");
    }
    const std::string attempt = trial + ", attempt " + std::to_string(result.attempt);
    if (result.attempt < 1 || result.attempt > kMaxAttempts) {
      return invalid_data(place + attempt + ": must be 1 to " + std::to_string(kMaxAttempts));
    }
    if (result.attempt > 1 && !seen.contains({result.trial, result.attempt - 1})) {
      return invalid_data(place + attempt + " comes before an earlier attempt");
    }
    if (!seen.emplace(result.trial, result.attempt).second) {
      return invalid_data(place + attempt + " occurs twice");
    }
    if (!is_known_reason(result.invalid)) {
      return invalid_data(place + "invalid: \"" + printable(result.invalid) + "\" is unknown");
    }
    if (result.recording != recording_name(result)) {
      return invalid_data(place + "recording: \"" + printable(result.recording) +
                          "\", it must be " + recording_name(result));
    }
  }
  return {};
}

Result<void> check_answer(const StudySession& session, const Study& study,
                          const QuestionAnswers& answer) {
  const std::string_view form = form_name(answer.form);
  const auto& forms = study.questionnaires;
  if (answer.after_trial < 1 ||
      static_cast<std::size_t>(answer.after_trial) > session.plan.size() ||
      !session.plan[static_cast<std::size_t>(answer.after_trial - 1)].asks_questions ||
      std::find(forms.begin(), forms.end(), answer.form) == forms.end()) {
    return invalid_data("the study does not ask " + std::string(form) + " after trial " +
                        std::to_string(answer.after_trial));
  }
  const ItemRange range = item_range(answer.form);
  const bool are_allowed =
      answer.values.size() == item_count(answer.form) &&
      std::all_of(answer.values.begin(), answer.values.end(), [range](double value) {
        return value >= range.min && value <= range.max && value == std::floor(value);
      });
  if (are_allowed) return {};
  return invalid_data("values: must be " + std::to_string(item_count(answer.form)) +
                      " whole numbers from " + std::to_string(range.min) + " to " +
                      std::to_string(range.max));
}

Result<void> check_answers(const StudySession& session, const Study& study) {
  std::set<std::pair<int, Questionnaire>> seen;
  for (std::size_t i = 0; i < session.answers.size(); ++i) {
    const QuestionAnswers& answer = session.answers[i];
    Result<void> valid = check_answer(session, study, answer);
    if (valid && !seen.emplace(answer.after_trial, answer.form).second) {
      valid = invalid_data(std::string(form_name(answer.form)) + " after trial " +
                           std::to_string(answer.after_trial) + " occurs twice");
    }
    if (!valid) {
      return tl::unexpected(with_context(valid.error(), "answers[" + std::to_string(i) + "]"));
    }
  }
  return {};
}

/// The members of a JSON object. Each key must be there, except `optional_key`; the first error is
/// kept.
class Members {
 public:
  Members(dom::element value, std::string place, std::span<const std::string_view> keys,
          std::string_view optional_key = {})
      : place_(std::move(place)) {
    dom::object object;
    if (value.get(object) != simdjson::SUCCESS) {
      wrong("must be an object");
      return;
    }
    std::set<std::string_view> seen;
    for (const auto& member : object) {
      const std::string key = "key \"" + printable(member.key) + "\"";
      const bool is_known = (!optional_key.empty() && member.key == optional_key) ||
                            std::find(keys.begin(), keys.end(), member.key) != keys.end();
      if (!is_known) wrong(key + " is unknown");
      if (!seen.insert(member.key).second) wrong(key + " occurs twice");
    }
    for (const std::string_view key : keys) {
      if (!seen.contains(key)) wrong("key \"" + std::string(key) + "\" is missing");
    }
    object_ = object;
    has_optional_ = seen.contains(optional_key);
  }

  [[nodiscard]] bool has_optional() const noexcept { return has_optional_; }

  std::string text(std::string_view key) {
    std::string_view text;
    if (ok() && object_[key].get(text) != simdjson::SUCCESS) wrong_type(key, "a text");
    return std::string(text);
  }
  /// Returns "" for null.
  std::string optional_text(std::string_view key) {
    return ok() && object_[key].is_null() ? "" : text(key);
  }
  int whole(std::string_view key) {
    std::int64_t number = 0;
    if (ok() &&
        (object_[key].get(number) != simdjson::SUCCESS || number < 0 || number > 1'000'000'000)) {
      wrong_type(key, "a whole number");
      number = 0;
    }
    return static_cast<int>(number);
  }
  std::optional<std::uint64_t> optional_seed(std::string_view key) {
    if (!ok() || object_[key].is_null()) return std::nullopt;
    std::uint64_t number = 0;
    if (object_[key].get(number) != simdjson::SUCCESS) wrong_type(key, "a whole number or null");
    return number;
  }
  dom::array list(std::string_view key) {
    dom::array list;
    if (ok() && object_[key].get(list) != simdjson::SUCCESS) wrong_type(key, "a list");
    return list;
  }
  /// Fails if the text of `key` is not `expected`.
  void expect(std::string_view key, std::string_view expected) {
    const std::string found = text(key);
    if (ok() && found != expected) {
      wrong(std::string(key) + " is \"" + printable(found) + "\", it must be \"" +
            std::string(expected) + "\"");
    }
  }
  void wrong(const std::string& reason) {
    if (ok())
      error_ = Error{ErrorCode::kInvalidData, place_.empty() ? reason : place_ + ": " + reason};
  }
  [[nodiscard]] bool ok() const noexcept { return !error_; }
  [[nodiscard]] Result<void> result() const {
    return error_ ? Result<void>(tl::unexpected(*error_)) : Result<void>();
  }

 private:
  void wrong_type(std::string_view key, const char* type) {
    wrong(std::string(key) + " must be " + type);
  }

  std::string place_;
  dom::object object_;
  bool has_optional_ = false;
  std::optional<Error> error_;
};

constexpr std::array<std::string_view, 10> kSessionKeys = {
    "format",  "version", "participant", "session", "device",
    "program", "started", "person_seed", "trials",  "answers"};
constexpr std::string_view kModelKey = "person_model";  // absent for real people
constexpr std::array<std::string_view, 6> kTrialKeys = {"trial", "attempt", "condition",
                                                        "shape", "invalid", "recording"};
constexpr std::string_view kFingerprintKey = "fingerprint";  // absent in older files
constexpr std::array<std::string_view, 3> kAnswerKeys = {"after_trial", "form", "values"};

Result<void> read_trial(dom::element value, const std::string& place, const Study& study,
                        StudySession& session) {
  Members members(value, place, kTrialKeys, kFingerprintKey);
  TrialResult result{.trial = members.whole("trial"),
                     .attempt = members.whole("attempt"),
                     .invalid = members.optional_text("invalid"),
                     .recording = members.text("recording")};
  if (members.has_optional()) {
    result.fingerprint = members.text(kFingerprintKey);
    if (!is_fingerprint(result.fingerprint)) {
      members.wrong("fingerprint must be fnv1a- and 16 hexadecimal digits");
    }
  }
  if (result.trial >= 1 && static_cast<std::size_t>(result.trial) <= session.plan.size()) {
    const PlannedTrial& planned = session.plan[static_cast<std::size_t>(result.trial - 1)];
    members.expect("condition", study.conditions[planned.condition].name);
    members.expect("shape", study.shapes[planned.shape].name);
  }  // check_session() reports other trials
  session.results.push_back(std::move(result));
  return members.result();
}

Result<void> read_answer(dom::element value, const std::string& place, StudySession& session) {
  Members members(value, place, kAnswerKeys);
  QuestionAnswers answer{members.whole("after_trial"), Questionnaire::kNasaTlx, {}};
  const std::string form = members.text("form");
  const auto known = std::find(kQuestionnaires.begin(), kQuestionnaires.end(), form);
  if (known == kQuestionnaires.end()) {
    members.wrong("form \"" + printable(form) + "\" is unknown");
  } else {
    answer.form = static_cast<Questionnaire>(known - kQuestionnaires.begin());
  }
  const dom::array values = members.list("values");
  if (!members.ok()) return members.result();
  for (const dom::element item : values) {
    double number = 0.0;
    if (item.get(number) != simdjson::SUCCESS) members.wrong("values must be numbers");
    answer.values.push_back(number);
  }
  session.answers.push_back(std::move(answer));
  return members.result();
}

/// Reads the members of the file into `session`, which has its plan.
Result<void> read_members(dom::element root, const Study& study, StudySession& session) {
  Members members(root, "", kSessionKeys, kModelKey);
  members.expect("format", kFormat);
  const int version = members.whole("version");
  if (members.ok() && version != kSessionVersion) {
    members.wrong("version " + std::to_string(version) +
                  " is not supported; a newer Feltline may have written it");
  }
  const int participant = members.whole("participant");
  if (members.ok() && participant != session.info.participant) {
    members.wrong("participant is " + std::to_string(participant) +
                  ", but the folder is that of participant " +
                  std::to_string(session.info.participant));
  }
  members.expect("session", session_name(session.info.session));
  session.info.device = members.text("device");
  session.info.program = members.text("program");
  session.info.started = members.optional_text("started");
  session.info.person_seed = members.optional_seed("person_seed");
  if (members.has_optional()) {
    session.info.person_model = members.text(kModelKey);
    if (!find_person_model(session.info.person_model)) members.wrong("person_model is unknown");
    if (!session.info.person_seed) members.wrong("person_model belongs to a person_seed");
  }
  const dom::array trials = members.list("trials"), answers = members.list("answers");
  if (!members.ok()) return members.result();
  std::size_t index = 0;
  for (const dom::element trial : trials) {
    Result<void> read =
        read_trial(trial, "trials[" + std::to_string(index++) + "]", study, session);
    if (!read) return read;
  }
  index = 0;
  for (const dom::element answer : answers) {
    Result<void> read = read_answer(answer, "answers[" + std::to_string(index++) + "]", session);
    if (!read) return read;
  }
  return {};
}

}  // namespace

std::size_t item_count(Questionnaire form) noexcept {
  return form == Questionnaire::kNasaTlx ? 6 : 8;
}

ItemRange item_range(Questionnaire form) noexcept {
  return form == Questionnaire::kNasaTlx ? ItemRange{0, 100} : ItemRange{1, 7};
}

std::string recording_name(const TrialResult& result) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "trial-%04d", result.trial);
  const std::string attempt = result.attempt == 1 ? "" : "-" + std::to_string(result.attempt);
  return name.data() + attempt + ".felt";
}

Result<void> check_session(const StudySession& session, const Study& study) {
  if (Result<void> valid = check_info(session.info); !valid) return valid;
  if (Result<void> valid = check_results(session); !valid) return valid;
  return check_answers(session, study);
}

std::string session_to_json(const StudySession& session, const Study& study) {
  std::vector<std::string> trials, answers;
  for (const TrialResult& result : session.results) {
    const PlannedTrial& planned = session.plan[static_cast<std::size_t>(result.trial - 1)];
    JsonObject trial;
    trial.add_number("trial", result.trial);
    trial.add_number("attempt", result.attempt);
    trial.add_text("condition", study.conditions[planned.condition].name);
    trial.add_text("shape", study.shapes[planned.shape].name);
    trial.add_raw("invalid", result.invalid.empty() ? "null" : json_string(result.invalid));
    trial.add_text("recording", result.recording);
    if (!result.fingerprint.empty()) trial.add_text(kFingerprintKey, result.fingerprint);
    trials.push_back("\n" + trial.text());
  }
  for (const QuestionAnswers& answer : session.answers) {
    std::vector<std::string> values;
    for (const double value : answer.values) values.push_back(json_number(value));
    JsonObject object;
    object.add_number("after_trial", answer.after_trial);
    object.add_text("form", form_name(answer.form));
    object.add_raw("values", json_array(values));
    answers.push_back("\n" + object.text());
  }
  const SessionInfo& info = session.info;
  JsonObject all;
  all.add_text("format", kFormat);
  all.add_number("version", kSessionVersion);
  all.add_number("participant", info.participant);
  all.add_text("session", session_name(info.session));
  all.add_text("device", info.device);
  all.add_text("program", info.program);
  all.add_raw("started", info.started.empty() ? "null" : json_string(info.started));
  all.add_raw("person_seed", info.person_seed ? std::to_string(*info.person_seed) : "null");
  if (!info.person_model.empty()) all.add_text(kModelKey, info.person_model);
  all.add_raw("trials", json_array(trials));
  all.add_raw("answers", json_array(answers));
  return all.text() + "\n";
}

Result<StudySession> session_from_json(std::string_view text, const Study& study,
                                       const SessionInfo& expected) {
  Result<std::vector<PlannedTrial>> plan =
      plan_trials(study, expected.participant, expected.session);
  if (!plan) return tl::unexpected(plan.error());
  StudySession session;
  session.info.participant = expected.participant;
  session.info.session = expected.session;
  session.plan = *std::move(plan);
  if (text.size() > kMaxSessionBytes) {
    return fail(ErrorCode::kLimitExceeded, "larger than 16 MiB");
  }
  dom::parser parser;
  dom::element root;
  const simdjson::padded_string padded(text);
  if (const auto error = parser.parse(padded).get(root)) {
    return invalid_data(std::string("not JSON: ") + simdjson::error_message(error));
  }
  if (Result<void> read = read_members(root, study, session); !read) {
    return tl::unexpected(read.error());
  }
  if (Result<void> valid = check_session(session, study); !valid) {
    return tl::unexpected(valid.error());
  }
  return session;
}

}  // namespace felt
