#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/trial/study.h"

namespace felt {

/// Participants have numbers from 1 to this one.
inline constexpr int kMaxParticipants = 9999;
/// The smallest number whose report has tests and intervals (kMinIntervalValues).
inline constexpr int kMinParticipants = 5;

/// One trial of a session: a participant draws one shape in one condition.
struct PlannedTrial {
  int number = 1;  ///< in the session, from 1
  SessionKind session = SessionKind::kTrain;
  int block = 0;              ///< from 1; 0 for practice trials
  std::size_t condition = 0;  ///< the index in Study::conditions
  std::size_t shape = 0;      ///< the index in Study::shapes
  int repetition = 1;         ///< of the shape in this condition and block, from 1
  bool is_practice = false;
  double rest_before_s = 0.0;   ///< the shortest rest before this trial; 0: none
  bool asks_questions = false;  ///< true: the questionnaires are shown after this trial
  /// The condition as the participant may see it: its label, or "A", "B", ... in a blind study.
  std::string shown_condition = {};
  std::uint64_t seed = 0;  ///< for everything random in this trial; differs between trials
  friend bool operator==(const PlannedTrial&, const PlannedTrial&) = default;
};

/// Returns the trials of a session in their order. The same study, participant and session always
/// give the same trials. Fails if the number of the participant is not 1 to kMaxParticipants, or if
/// the study does not have the session.
///
/// Practice trials come first. Then each block has all conditions of the session; each condition
/// has all shapes of the session, as often as Study::repetitions says.
///
/// A balanced Latin square is a Williams design: if the number of participants is a multiple of the
/// number of its rows, each condition is equally often in each position, and each condition comes
/// equally often directly after each other one. The design has n rows for an even number n of
/// conditions, and two squares with 2n rows for an odd number. Participant p uses row p in the
/// first block, row p + 1 in the next block, and so on, also from one session to the next. The seed
/// of the study decides which condition is which letter of the square. Source: E. J. Williams,
/// "Experimental designs balanced for the estimation of residual effects of treatments", Australian
/// Journal of Scientific Research A 2 (1949) 149-168, DOI 10.1071/CH9490149.
Result<std::vector<PlannedTrial>> plan_trials(const Study& study, int participant,
                                              SessionKind session);

/// Returns the letter ("A", "B", ...) of each condition of the study for a participant of a blind
/// study. The letters are the same in all sessions. Requires at most kMaxStudyConditions
/// conditions.
std::vector<std::string> blind_labels(const Study& study, int participant);

/// Return the indices of the conditions and of the shapes of a session, in the order of the study.
std::vector<std::size_t> conditions_in(const Study& study, SessionKind session);
std::vector<std::size_t> shapes_in(const Study& study, SessionKind session);
/// Returns the number of trials of a session, including practice trials.
std::size_t trial_count(const Study& study, SessionKind session);

/// Returns a row of a Williams design for `count` conditions: a permutation of 0 to count - 1. Rows
/// repeat after williams_rows(). Requires count > 0.
std::vector<std::size_t> williams_row(std::size_t count, std::size_t row);
/// Returns the number of rows of the design: `count` if it is even, otherwise twice `count`; 1 for
/// one condition.
std::size_t williams_rows(std::size_t count) noexcept;

}  // namespace felt
