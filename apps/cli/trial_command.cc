#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "felt/autosave/folder_lock.h"
#include "felt/studies/simulate_study.h"
#include "felt/studies/trial_setup.h"
#include "interrupt.h"
#include "print.h"

namespace felt::cli {
namespace {

constexpr const char* kSimulateExamples =
    "feltline trial simulate keefe.toml -o results\n"
    "feltline trial simulate keefe.toml --people 40 --seed 7 --device inverse3 -o results";

struct SimulateArguments {
  std::string study, folder;
  std::size_t people = 20;
  std::uint64_t seed = 1;
  std::string device = "premium", model = "resting";
};

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const StylusPreset& preset : stylus_presets()) names.emplace_back(preset.name);
  return names;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const PersonModel model : kPersonModels) names.emplace_back(person_model_name(model));
  return names;
}

/// Reads and checks the study, and opens or creates the folder for its results.
Result<StudyFolder> open_folder(const SimulateArguments& args, const StylusPreset& device) {
  Result<StudyFiles> files = read_study_files(args.study);
  if (!files) return tl::unexpected(files.error());
  const Result<void> possible =
      check_conditions(*files, Materials::built_in(), device.capabilities, args.study);
  if (!possible) return tl::unexpected(possible.error());
  return StudyFolder::open_or_create(args.folder, *std::move(files));
}

struct TrialCounts {
  std::size_t people = 0, trials = 0, invalid = 0;
};

Result<TrialCounts> count_trials(const StudyFolder& folder) {
  const Result<std::vector<StudySession>> sessions = folder.sessions();
  if (!sessions) return tl::unexpected(sessions.error());
  TrialCounts counts;
  int last = 0;
  for (const StudySession& session : *sessions) {
    if (std::exchange(last, session.info.participant) != session.info.participant) ++counts.people;
    counts.trials += session.results.size();
    for (const TrialResult& result : session.results) counts.invalid += !result.invalid.empty();
  }
  return counts;
}

void run_simulate(const SimulateArguments& args, Console& console) {
  const StylusPreset& device = *find_stylus_preset(args.device);
  Result<StudyFolder> folder = open_folder(args, device);
  if (!folder) return console.error(folder.error().message);
  const Result<FolderLock> lock = FolderLock::take(folder->path());
  if (!lock) return console.error(lock.error().message);
  const Interrupt interrupt;
  const auto progress = [&console](double share) {
    console.status(fmt::format("simulating {:.1f} %", 100.0 * share));
    return !Interrupt::was_asked();
  };
  const Result<void> done = simulate_study(
      *folder,
      {args.people, args.seed, *find_person_model(args.model), device, "feltline " FELT_VERSION},
      progress);
  console.end_progress();
  if (!done) return console.error(done.error().message);
  const Result<TrialCounts> counts = count_trials(*folder);
  if (!counts) return console.error(counts.error().message);
  print("{}: {} people, {} trials, {} of them invalid\n", args.folder, counts->people,
        counts->trials, counts->invalid);
  if (Interrupt::was_asked()) {
    console.error(
        "interrupted; the folder has the finished trials, and the same command does the rest");
  }
}

void add_simulate(CLI::App& trial, Console& console) {
  CLI::App* command = trial.add_subcommand("simulate", "Let simulated people take part in a study");
  const auto args = std::make_shared<SimulateArguments>();
  command->add_option("STUDY", args->study, "The study, a .toml file")->required();
  command
      ->add_option("-o,--output", args->folder,
                   "The folder for the results: new, empty, or with a part of the same results")
      ->required();
  command->add_option("--people", args->people, "Number of simulated people")
      ->check(CLI::Range(1, kMaxParticipants))
      ->capture_default_str();
  command->add_option("--seed", args->seed, "Another seed gives other people")
      ->check(whole_number())
      ->capture_default_str();
  command->add_option("--device", args->device, "The simulated device that they use")
      ->check(CLI::IsMember(preset_names()))
      ->capture_default_str();
  command->add_option("--model", args->model, "How they feel and move")
      ->check(CLI::IsMember(model_names()))
      ->capture_default_str();
  command->footer(
      "Simulated people do not learn and do not answer questionnaires. Ctrl-C ends early and "
      "keeps\n"
      "the finished trials; the same command continues.\n" +
      examples(kSimulateExamples));
  command->callback([args, &console] { run_simulate(*args, console); });
}

constexpr const char* kDesktop = "feltline-desktop";

struct RunArguments {
  std::string study, folder, session = "train", language;
  int participant = 1;
};

/// Replaces this process by the desktop program, which is beside this program or in PATH. Returns
/// only if that fails.
void become_desktop(const std::vector<std::string>& options) {
  std::vector<std::string> all{kDesktop};
  all.insert(all.end(), options.begin(), options.end());
  std::vector<char*> words;
  words.reserve(all.size() + 1);
  for (std::string& word : all) words.push_back(word.data());
  words.push_back(nullptr);
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) ::execv((self.parent_path() / kDesktop).c_str(), words.data());
  ::execvp(kDesktop, words.data());
}

void run_session(const RunArguments& args, Console& console) {
  std::vector<std::string> options{"--trial",   args.study,      "--output",
                                   args.folder, "--participant", std::to_string(args.participant),
                                   "--session", args.session};
  if (!args.language.empty()) options.insert(options.end(), {"--language", args.language});
  become_desktop(options);
  if (errno != ENOENT) {
    return console.error(fmt::format("{} cannot be started: {}", kDesktop, std::strerror(errno)));
  }
  console.error(
      fmt::format("{} is not installed: it is neither beside feltline nor in PATH", kDesktop));
}

void add_run(CLI::App& trial, Console& console) {
  CLI::App* command = trial.add_subcommand("run", "Seat a participant: a session on the screen");
  const auto args = std::make_shared<RunArguments>();
  command->add_option("STUDY", args->study, "The study, a .toml file")->required();
  command
      ->add_option("-o,--output", args->folder,
                   "The folder for the results of all participants of this study")
      ->required();
  command->add_option("--participant", args->participant, "The number of the participant")
      ->check(CLI::Range(1, kMaxParticipants))
      ->required();
  command->add_option("--session", args->session, "The session of the participant")
      ->check(CLI::IsMember(std::vector<std::string>(kSessionKinds.begin(), kSessionKinds.end())))
      ->capture_default_str();
  command->add_option("--language", args->language, "The language of the texts: en, de, nl")
      ->check(CLI::IsMember({"en", "de", "nl"}));
  command->footer(
      "Starts feltline-desktop with the pen device of its preferences. The same command continues\n"
      "a session that was stopped or interrupted.\n" +
      examples("feltline trial run keefe.toml -o results --participant 3\n"
               "feltline trial run keefe.toml -o results --participant 3 --session post"));
  command->callback([args, &console] { run_session(*args, console); });
}

}  // namespace

void add_trial_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("trial", "Run a study and keep its results");
  command->require_subcommand(1);
  command->fallthrough();
  add_trial_preregister_command(*command, console);
  add_run(*command, console);
  add_simulate(*command, console);
  add_trial_export_command(*command, console);
}

}  // namespace felt::cli
