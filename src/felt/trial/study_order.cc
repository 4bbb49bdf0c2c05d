#include "felt/trial/study_order.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <utility>

#include "felt/base/random.h"

namespace felt {
namespace {

/// The random numbers of one use in a study.
class StudyRandom {
 public:
  /// What the numbers are for, so that different uses are independent.
  enum class Use : std::uint64_t { kLetters = 1, kBlind, kConditions, kShapes, kTrial };

  StudyRandom(const Study& study, Use use, std::initializer_list<std::uint64_t> parts)
      : random_(seed_of(study.seed, use, parts)) {}

  std::uint64_t next() noexcept { return random_.bits(); }

  /// Returns a permutation of 0 to count - 1 (Fisher and Yates).
  std::vector<std::size_t> permutation(std::size_t count) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[below(i)]);
    return order;
  }

 private:
  static std::uint64_t seed_of(std::uint64_t seed, Use use,
                               std::initializer_list<std::uint64_t> parts) noexcept {
    const auto mixed = [](std::uint64_t state, std::uint64_t part) {
      return Random(state ^ part * 0xd1342543de82ef95ULL).bits();
    };
    seed = mixed(seed, static_cast<std::uint64_t>(use));
    for (const std::uint64_t part : parts) seed = mixed(seed, part);
    return seed;
  }

  /// Returns a number below `bound`. Numbers at the end of the range are drawn again, because they
  /// would make small results more likely.
  std::size_t below(std::uint64_t bound) noexcept {
    const std::uint64_t unfair = (0 - bound) % bound;
    std::uint64_t number = next();
    while (number < unfair) number = next();
    return static_cast<std::size_t>(number % bound);
  }

  Random random_;
};

using Use = StudyRandom::Use;

bool is_in(const std::vector<SessionKind>& sessions, SessionKind session) {
  return sessions.empty() || std::find(sessions.begin(), sessions.end(), session) != sessions.end();
}

template <class Part>
std::vector<std::size_t> parts_in(const std::vector<Part>& parts, SessionKind session) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_in(parts[i].sessions, session)) indices.push_back(i);
  }
  return indices;
}

/// The position of a block in the whole study, from 0, and of a run through the shapes in it.
struct StudyPosition {
  std::uint64_t participant, block, condition, repetition;
};

/// Builds the trials of one session.
class SessionPlan {
 public:
  SessionPlan(const Study& study, int participant, SessionKind session)
      : study_(study),
        participant_(static_cast<std::uint64_t>(participant)),
        session_(session),
        conditions_(conditions_in(study, session)),
        shapes_(shapes_in(study, session)),
        letters_(blind_labels(study, participant)) {
    const auto at = std::find(study.sessions.begin(), study.sessions.end(), session);
    first_block_ = static_cast<std::uint64_t>(at - study.sessions.begin()) *
                   static_cast<std::uint64_t>(study.blocks);
  }

  std::vector<PlannedTrial> trials() && {
    add_practice();
    for (int block = 1; block <= study_.blocks; ++block) add_block(block);
    if (!study_.questionnaires.empty()) mark_questions();
    return std::move(trials_);
  }

 private:
  [[nodiscard]] std::uint64_t position_of(int block) const noexcept {
    return first_block_ + static_cast<std::uint64_t>(block > 0 ? block - 1 : 0);
  }

  /// Returns the indices of `parts` in the order of a block. `visit` differs between the conditions
  /// and repetitions for which shapes are ordered.
  [[nodiscard]] std::vector<std::size_t> ordered(const std::vector<std::size_t>& parts,
                                                 StudyOrder order, Use use, int block,
                                                 std::uint64_t visit) const {
    const std::uint64_t position = position_of(block);
    const std::size_t count = parts.size();
    std::vector<std::size_t> at(count);
    std::iota(at.begin(), at.end(), std::size_t{0});
    if (order == StudyOrder::kRandom) {
      at = StudyRandom(study_, use, {participant_, position, visit}).permutation(count);
    } else if (order == StudyOrder::kBalancedLatinSquare) {
      const auto letters =
          StudyRandom(study_, Use::kLetters, {static_cast<std::uint64_t>(use)}).permutation(count);
      at = williams_row(count, static_cast<std::size_t>(participant_ - 1 + position + visit));
      for (std::size_t& i : at) i = letters[i];
    }
    for (std::size_t& i : at) i = parts[i];
    return at;
  }

  void add(int block, std::size_t condition, std::size_t shape, int repetition) {
    PlannedTrial trial;
    trial.number = static_cast<int>(trials_.size()) + 1;
    trial.session = session_;
    trial.block = block;
    trial.condition = condition;
    trial.shape = shape;
    trial.repetition = repetition;
    trial.is_practice = block == 0;
    trial.shown_condition =
        study_.is_blind ? letters_[condition] : study_.conditions[condition].label;
    trial.seed = StudyRandom(study_, Use::kTrial,
                             {participant_, static_cast<std::uint64_t>(session_),
                              static_cast<std::uint64_t>(trial.number)})
                     .next();
    const bool is_new_block = !trials_.empty() && trials_.back().block != block;
    const bool is_due = study_.rest_after_trials > 0 && since_rest_ >= study_.rest_after_trials;
    if (study_.rest_s > 0.0 && (is_new_block || is_due)) {
      trial.rest_before_s = study_.rest_s;
      since_rest_ = 0;
    }
    ++since_rest_;
    trials_.push_back(std::move(trial));
  }

  void add_practice() {
    const auto count = static_cast<std::size_t>(study_.practice_trials);
    if (count == 0) return;
    for (const std::size_t condition : ordered(conditions_, study_.order, Use::kConditions, 0, 0)) {
      for (std::size_t i = 0; i < count; ++i) {
        add(0, condition, shapes_[i % shapes_.size()], static_cast<int>(i / shapes_.size()) + 1);
      }
    }
  }

  void add_block(int block) {
    const auto repetitions = static_cast<std::uint64_t>(study_.repetitions);
    std::uint64_t visit = 0;
    for (const std::size_t condition :
         ordered(conditions_, study_.order, Use::kConditions, block, 0)) {
      for (std::uint64_t i = 0; i < repetitions; ++i, ++visit) {
        for (const std::size_t shape :
             ordered(shapes_, study_.shape_order, Use::kShapes, block, visit)) {
          add(block, condition, shape, static_cast<int>(i) + 1);
        }
      }
    }
  }

  void mark_questions() {
    if (study_.question_time == QuestionTime::kSession) {
      trials_.back().asks_questions = true;
      return;
    }
    for (const std::size_t condition : conditions_) {
      const auto last = std::find_if(
          trials_.rbegin(), trials_.rend(),
          [condition](const PlannedTrial& trial) { return trial.condition == condition; });
      last->asks_questions = true;
    }
  }

  const Study& study_;
  std::uint64_t participant_;
  SessionKind session_;
  std::vector<std::size_t> conditions_, shapes_;
  std::vector<std::string> letters_;
  std::uint64_t first_block_ = 0;
  int since_rest_ = 0;
  std::vector<PlannedTrial> trials_;
};

}  // namespace

std::vector<std::size_t> conditions_in(const Study& study, SessionKind session) {
  return parts_in(study.conditions, session);
}

std::vector<std::size_t> shapes_in(const Study& study, SessionKind session) {
  return parts_in(study.shapes, session);
}

std::size_t trial_count(const Study& study, SessionKind session) {
  const std::size_t in_block =
      shapes_in(study, session).size() * static_cast<std::size_t>(study.repetitions);
  return conditions_in(study, session).size() * (in_block * static_cast<std::size_t>(study.blocks) +
                                                 static_cast<std::size_t>(study.practice_trials));
}

std::size_t williams_rows(std::size_t count) noexcept {
  return count < 2 ? 1 : count % 2 == 0 ? count : 2 * count;
}

std::vector<std::size_t> williams_row(std::size_t count, std::size_t row) {
  row %= williams_rows(count);
  // The first row is 0, 1, count - 1, 2, count - 2, ...: neighbours differ by every number once.
  // Each other row adds its number. The second square has the rows of the first one in reverse.
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t letter = i % 2 == 1 ? (i + 1) / 2 : (count - i / 2) % count;
    order[i] = (letter + row) % count;
  }
  if (row >= count) std::reverse(order.begin(), order.end());
  return order;
}

std::vector<std::string> blind_labels(const Study& study, int participant) {
  std::vector<std::string> labels;
  for (const std::size_t letter :
       StudyRandom(study, Use::kBlind, {static_cast<std::uint64_t>(participant)})
           .permutation(study.conditions.size())) {
    labels.emplace_back(1, static_cast<char>('A' + letter));
  }
  return labels;
}

Result<std::vector<PlannedTrial>> plan_trials(const Study& study, int participant,
                                              SessionKind session) {
  if (participant < 1 || participant > kMaxParticipants) {
    return fail(ErrorCode::kInvalidArgument, "participant is " + std::to_string(participant) +
                                                 ", it must be 1 to " +
                                                 std::to_string(kMaxParticipants));
  }
  const std::string name(kSessionKinds[static_cast<std::size_t>(session)]);
  if (std::find(study.sessions.begin(), study.sessions.end(), session) == study.sessions.end()) {
    std::string all;
    for (const SessionKind kind : study.sessions) {
      all += (all.empty() ? "" : ", ") + std::string(kSessionKinds[static_cast<std::size_t>(kind)]);
    }
    return fail(ErrorCode::kInvalidArgument,
                "the study has no session \"" + name + "\"; it has " + all);
  }
  const std::size_t count = trial_count(study, session);
  if (count == 0 || shapes_in(study, session).empty()) {
    return fail(ErrorCode::kInvalidArgument, "session \"" + name + "\" has no trials");
  }
  if (count > kMaxSessionTrials || study.conditions.size() > kMaxStudyConditions) {
    return fail(ErrorCode::kLimitExceeded, "session \"" + name + "\" has too many trials");
  }
  return SessionPlan(study, participant, session).trials();
}

}  // namespace felt
