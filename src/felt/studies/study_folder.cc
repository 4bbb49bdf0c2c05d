#include "felt/studies/study_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <map>
#include <span>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/hash.h"
#include "felt/base/read_file.h"
#include "felt/store/felt_file.h"
#include "felt/studies/session_file.h"
#include "felt/studies/trial_setup.h"

namespace felt {
namespace {

constexpr const char* kSessionFile = "session.json";

std::string padded(int number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%04d", number);
  return text.data();
}

/// Creates a folder, and writes its name to the disk. Succeeds if the folder exists.
Result<void> make_folder(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::create_directory(path, error) && !std::filesystem::is_directory(path)) {
    const std::string reason = error ? error.message() : "a file has this name";
    return fail(ErrorCode::kIo, path + ": cannot create the folder: " + reason);
  }
  std::string parent = std::filesystem::path(path).parent_path().string();
  if (parent.empty()) parent = ".";
  const int folder = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return {};
  ::fsync(folder);
  ::close(folder);
  return {};
}

/// Returns the number of a folder "participant-0001", or nullopt for any other name. Fails if the
/// name starts in this way but has no valid number.
Result<std::optional<int>> participant_of(const std::string& name) {
  if (!name.starts_with(kParticipantPrefix)) return std::optional<int>();
  const std::string digits = name.substr(kParticipantPrefix.size());
  const bool is_number = digits.size() == 4 && digits != "0000" &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  if (!is_number) return invalid_data("the name must end in 0001 to 9999");
  return std::optional(std::stoi(digits));
}

/// Returns the sorted numbers of the participants.
Result<std::vector<int>> participants_in(const std::string& path) {
  std::vector<int> participants;
  std::error_code error;
  std::filesystem::directory_iterator entry(path, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const Result<std::optional<int>> participant =
        participant_of(entry->path().filename().string());
    if (!participant) {
      return tl::unexpected(with_context(participant.error(), entry->path().string()));
    }
    if (*participant) participants.push_back(**participant);
  }
  if (error) return fail(ErrorCode::kIo, path + ": cannot read the folder: " + error.message());
  std::sort(participants.begin(), participants.end());
  return participants;
}

bool have_equal_sources(const StudyFiles& a, const StudyFiles& b) {
  return a.sources.front().second == b.sources.front().second &&
         std::equal(a.sources.begin() + 1, a.sources.end(), b.sources.begin() + 1, b.sources.end());
}

Result<FeltRecording> last_recording(std::string_view bytes) {
  const Result<Drawing> drawing = parse_felt(bytes);
  if (!drawing) return tl::unexpected(drawing.error());
  const auto all = recordings_of(*drawing);
  if (!all) return tl::unexpected(all.error());
  if (all->empty()) return invalid_data("has no recording");
  return read_recording(*drawing, all->size() - 1);
}

/// Returns false if another value of an option of the trial's condition, or another guide, is in
/// effect when the pen first touches the surface. Before that, hover samples may lie between the
/// events that set up the trial. A recording without events, of another program, may be of any
/// trial.
bool may_be_of(const FeltRecording& recording, const StudyFiles& files, const SessionInfo& info,
               int trial) {
  const auto plan = plan_trials(files.study, info.participant, info.session);
  if (!plan || trial < 1 || static_cast<std::size_t>(trial) > plan->size()) return false;
  if (recording.events.empty()) return true;
  const auto landed =
      std::find_if(recording.samples.begin(), recording.samples.end(),
                   [](const RecordedSample& s) { return in_contact(sample_of(s.time_ns, s.pen)); });
  const auto hover_samples = static_cast<std::size_t>(landed - recording.samples.begin());
  GuideLine guide;
  std::map<std::string, OptionValue> options;
  for (const RecordedEvent& recorded : recording.events) {
    if (recorded.before_sample > hover_samples) break;
    if (const auto* set = std::get_if<SetOption>(&recorded.event.what))
      options[set->id] = set->value;
    if (const auto* use = std::get_if<UseGuide>(&recorded.event.what)) guide = use->line;
  }
  GuideLine wanted;
  const PlannedTrial& planned = (*plan)[static_cast<std::size_t>(trial - 1)];
  for (const Event& event : setup_events(files, planned, Capabilities())) {
    if (const auto* use = std::get_if<UseGuide>(&event.what)) wanted = use->line;
    const auto* set = std::get_if<SetOption>(&event.what);
    if (!set) continue;
    const auto found = options.find(set->id);
    if (found == options.end() || found->second != set->value) return false;
  }
  return guide == wanted;
}

bool exists(const std::string& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

}  // namespace

std::string fingerprint_of(std::string_view bytes) {
  Fnv1a hash;
  hash.add(std::as_bytes(std::span(bytes)));
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "fnv1a-%016" PRIx64, hash.value());
  return text.data();
}

bool TrialAttempts::is_done(const CatchRules& rules) const noexcept {
  return has_valid || invalid > (rules.action == CatchAction::kRepeat ? rules.max_repeats : 0);
}

TrialAttempts attempts_of(const StudySession& session, int trial) {
  TrialAttempts all;
  for (const TrialResult& result : session.results) {
    if (result.trial != trial) continue;
    all.last = std::max(all.last, result.attempt);
    if (result.invalid == kInterrupted) continue;
    all.has_valid = all.has_valid || result.invalid.empty();
    if (!result.invalid.empty()) ++all.invalid;
    all.broken_rule = result.invalid;
  }
  return all;
}

std::size_t done_trials(const StudySession& session, const CatchRules& rules) {
  return static_cast<std::size_t>(
      std::count_if(session.plan.begin(), session.plan.end(), [&](const PlannedTrial& trial) {
        return attempts_of(session, trial.number).is_done(rules);
      }));
}

StudyFolder::StudyFolder(std::string path, StudyFiles files)
    : path_(std::move(path)), files_(std::move(files)) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
}

Result<StudyFolder> StudyFolder::create(const std::string& path, StudyFiles files) {
  std::error_code error;
  if (exists(path) && !std::filesystem::is_empty(path, error)) {
    return fail(ErrorCode::kIo, path + (error ? ": cannot read the folder: " + error.message()
                                              : ": exists and is not empty"));
  }
  StudyFolder folder(path, std::move(files));
  if (Result<void> made = make_folder(folder.path_); !made) return tl::unexpected(made.error());
  folder.files_.sources.front().first = kStudyFileName;
  // The study is written last: a folder with a study is complete.
  for (auto source = folder.files_.sources.rbegin(); source != folder.files_.sources.rend();
       ++source) {
    Result<void> saved = save_file(folder.path_ + "/" + source->first, source->second);
    if (!saved) return tl::unexpected(saved.error());
  }
  return folder;
}

Result<StudyFolder> StudyFolder::open_or_create(const std::string& path, StudyFiles files) {
  std::error_code error;
  const bool is_new = !exists(path) || (std::filesystem::is_directory(path, error) &&
                                        std::filesystem::is_empty(path, error));
  if (is_new) return create(path, std::move(files));
  Result<StudyFolder> folder = open(path);
  if (!folder || have_equal_sources(folder->files_, files)) return folder;
  return fail(ErrorCode::kInvalidArgument,
              path +
                  ": has the results of another study: its study.toml, or a file that it names, "
                  "differs from " +
                  files.sources.front().first + ". Use another folder.");
}

Result<StudyFolder> StudyFolder::open(const std::string& path) {
  StudyFolder folder(path, {});
  const std::string study = folder.path_ + "/" + std::string(kStudyFileName);
  if (!exists(study)) {
    return fail(ErrorCode::kNotFound, path +
                                          ": not a folder with the results of a study (it has no " +
                                          std::string(kStudyFileName) + ")");
  }
  Result<StudyFiles> files = read_study_files(study);
  if (!files) return tl::unexpected(files.error());
  folder.files_ = *std::move(files);
  return folder;
}

std::string StudyFolder::file_of(const SessionInfo& info, const std::string& name) const {
  return path_ + "/" + std::string(kParticipantPrefix) + padded(info.participant) + "/" +
         std::string(session_name(info.session)) + "/" + name;
}

Result<StudySession> StudyFolder::read_session(const SessionInfo& info) const {
  const std::string file = file_of(info, kSessionFile);
  Result<std::string> text = read_regular_file(file, kMaxSessionBytes);
  if (!text) return tl::unexpected(text.error());
  Result<StudySession> session = session_from_json(*text, files_.study, info);
  if (!session) return tl::unexpected(with_context(session.error(), file));
  return session;
}

Result<void> StudyFolder::write_session(const StudySession& session) const {
  return save_file(file_of(session.info, kSessionFile), session_to_json(session, files_.study));
}

Result<StudySession> StudyFolder::begin_session(const SessionInfo& info) {
  Result<std::vector<PlannedTrial>> plan =
      plan_trials(files_.study, info.participant, info.session);
  if (!plan) return tl::unexpected(plan.error());
  if (exists(file_of(info, kSessionFile))) return read_session(info);
  StudySession session{info, *std::move(plan), {}, {}};
  if (Result<void> valid = check_session(session, files_.study); !valid) {
    return tl::unexpected(valid.error());
  }
  const std::string folder = std::filesystem::path(file_of(info, kSessionFile)).parent_path();
  for (const std::string& part : {std::filesystem::path(folder).parent_path().string(), folder}) {
    if (Result<void> made = make_folder(part); !made) return tl::unexpected(made.error());
  }
  if (Result<void> saved = write_session(session); !saved) return tl::unexpected(saved.error());
  return session;
}

Result<void> StudyFolder::check_begun(const SessionInfo& info) const {
  if (exists(file_of(info, kSessionFile))) return {};
  return fail(ErrorCode::kInvalidArgument, file_of(info, kSessionFile) + ": was not begun");
}

Result<void> StudyFolder::add_trial(StudySession& session, TrialResult result,
                                    const Drawing& drawing) {
  result.recording = recording_name(result);
  const std::string file = file_of(session.info, result.recording);
  StudySession changed = session;
  changed.results.push_back(std::move(result));
  if (Result<void> valid = check_session(changed, files_.study); !valid) {
    return tl::unexpected(with_context(valid.error(), file));
  }
  if (Result<void> begun = check_begun(session.info); !begun) return begun;
  const Result<std::string> bytes = felt_bytes(drawing);
  if (!bytes) return tl::unexpected(with_context(bytes.error(), file));
  changed.results.back().fingerprint = fingerprint_of(*bytes);
  if (Result<void> saved = save_file(file, *bytes); !saved) return saved;
  if (Result<void> saved = write_session(changed); !saved) return saved;
  session = std::move(changed);
  return {};
}

Result<void> StudyFolder::add_answers(StudySession& session, QuestionAnswers answers) {
  StudySession changed = session;
  changed.answers.push_back(std::move(answers));
  if (Result<void> valid = check_session(changed, files_.study); !valid) {
    return tl::unexpected(with_context(valid.error(), file_of(session.info, kSessionFile)));
  }
  if (Result<void> begun = check_begun(session.info); !begun) return begun;
  if (Result<void> saved = write_session(changed); !saved) return saved;
  session = std::move(changed);
  return {};
}

Result<std::vector<StudySession>> StudyFolder::sessions() const {
  const Result<std::vector<int>> participants = participants_in(path_);
  if (!participants) return tl::unexpected(participants.error());
  std::vector<StudySession> sessions;
  for (const int participant : *participants) {
    for (std::size_t kind = 0; kind < kSessionKinds.size(); ++kind) {
      SessionInfo info;
      info.participant = participant;
      info.session = static_cast<SessionKind>(kind);
      if (!exists(file_of(info, kSessionFile))) continue;
      Result<StudySession> session = read_session(info);
      if (!session) return tl::unexpected(session.error());
      sessions.push_back(*std::move(session));
    }
  }
  const auto rank = [this](SessionKind kind) {
    const auto& kinds = files_.study.sessions;
    return std::find(kinds.begin(), kinds.end(), kind) - kinds.begin();
  };
  std::stable_sort(sessions.begin(), sessions.end(),
                   [&rank](const StudySession& a, const StudySession& b) {
                     return std::pair(a.info.participant, rank(a.info.session)) <
                            std::pair(b.info.participant, rank(b.info.session));
                   });
  return sessions;
}

Result<FeltRecording> StudyFolder::recording(const SessionInfo& info, const TrialResult& result,
                                             std::string* bytes) const {
  const std::string file = file_of(info, result.recording);
  Result<std::string> text = read_regular_file(file, check_felt_head);
  if (!text) return tl::unexpected(text.error());
  Result<FeltRecording> recording = last_recording(*text);
  if (!recording) return tl::unexpected(with_context(recording.error(), file));
  const bool belongs = result.fingerprint.empty()
                           ? may_be_of(*recording, files_, info, result.trial)
                           : result.fingerprint == fingerprint_of(*text);
  if (!belongs) {
    return invalid_data(
        file + ": is not the recording of trial " + std::to_string(result.trial) +
        ", or was changed after the trial; restore the original file from a backup");
  }
  if (bytes) *bytes = *std::move(text);
  return recording;
}

}  // namespace felt
