#include "console_person.h"

#include "print.h"
#include "question.h"
#include "text_table.h"

namespace felt::cli {

bool ConsolePerson::does(PersonTask task, const std::string& words) {
  const bool is_consent = task == PersonTask::kAgreeToForces || task == PersonTask::kFindHome;
  const bool needs_hands = task == PersonTask::kUnplug || task == PersonTask::kReplug;
  say("\n{}\n", wrapped(words, 80, 0));
  if (agrees_to_all_) return !needs_hands || somebody_is_there();
  return ask(is_consent ? "Do you agree?" : "Ready?");
}

}  // namespace felt::cli
