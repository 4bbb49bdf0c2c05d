#include "felt/trial/study_hypothesis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "felt/base/check.h"
#include "felt/base/printable.h"
#include "felt/material/number_text.h"
#include "felt/trial/study_order.h"
#include "felt/trial/trial_columns.h"

namespace felt {
namespace {

/// Metrics of which more is better, or which may be negative, so that a ratio says nothing.
constexpr std::array<std::string_view, 11> kWithoutRatio{
    "samples", "coverage",           "err_signed_mm",          "movement_offset_mm",
    "sparc",   "steering_id",        "log_dimensionless_jerk", "is_closed",
    "work_mj", "power_law_exponent", "power_law_r2",
};

bool has_no_ratio(std::string_view metric) noexcept {
  return std::find(kWithoutRatio.begin(), kWithoutRatio.end(), metric) != kWithoutRatio.end();
}

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

std::size_t find_condition(const Study& study, std::string_view name) {
  const auto at = std::find_if(study.conditions.begin(), study.conditions.end(),
                               [name](const StudyCondition& c) { return c.name == name; });
  return at == study.conditions.end() ? kNone
                                      : static_cast<std::size_t>(at - study.conditions.begin());
}

bool is_in_session(const Study& study, std::size_t condition, SessionKind session) {
  const std::vector<std::size_t> in = conditions_in(study, session);
  return std::find(in.begin(), in.end(), condition) != in.end();
}

/// Returns the session of a hypothesis; nullopt if no session has both conditions.
std::optional<SessionKind> find_session(const Study& study, const StudyHypothesis& hypothesis) {
  const std::size_t condition = find_condition(study, hypothesis.condition);
  const std::size_t against = find_condition(study, hypothesis.against);
  for (const SessionKind session : study.sessions) {
    if (hypothesis.session && *hypothesis.session != session) continue;
    if (is_in_session(study, condition, session) && is_in_session(study, against, session)) {
      return session;
    }
  }
  return std::nullopt;
}

std::string metric_names() {
  std::string names;
  for (const TrialColumn& column : trial_metric_columns()) {
    names += (names.empty() ? "" : ", ") + std::string(column.name);
  }
  return names;
}

std::string condition_names(const Study& study) {
  std::string names;
  for (const StudyCondition& condition : study.conditions) {
    names += (names.empty() ? "" : ", ") + condition.name;
  }
  return names;
}

/// Checks one table [[hypothesis]].
class HypothesisCheck {
 public:
  using IsRefused = std::function<bool(std::string_view, std::size_t)>;
  using Say = std::function<void(int, const std::string&)>;

  HypothesisCheck(const Study& study, std::span<const TomlEntry> entries, std::size_t index,
                  const IsRefused& is_refused, const Say& say)
      : study_(study),
        hypothesis_(study.hypotheses[index]),
        entries_(entries),
        index_(index),
        is_refused_(is_refused),
        say_(say) {}

  void run() {
    const bool has_condition = check_condition("hypothesis.condition", hypothesis_.condition);
    const bool has_against = check_condition("hypothesis.against", hypothesis_.against);
    check_measure();
    check_margin();
    if (!has_condition || !has_against) return;
    if (hypothesis_.condition == hypothesis_.against) {
      say_(line_of("hypothesis.against"), "hypothesis.against is \"" + hypothesis_.against +
                                              "\", it must be another condition than "
                                              "hypothesis.condition");
    } else {
      check_session();
      check_twice();
    }
  }

 private:
  [[nodiscard]] const TomlEntry* find(std::string_view key) const {
    const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const TomlEntry& entry) {
      return entry.key == key && entry.table == static_cast<int>(index_);
    });
    return at == entries_.end() ? nullptr : &*at;
  }
  [[nodiscard]] int line_of(std::string_view key) const {
    const TomlEntry* entry = find(key);
    return entry ? entry->line : hypothesis_.line;
  }

  /// Returns true if the condition exists.
  bool check_condition(const std::string& key, const std::string& name) {
    if (is_refused_(key, index_)) return false;
    if (!find(key)) {
      say_(hypothesis_.line, key + " is missing; it must be the name of a condition");
      return false;
    }
    if (find_condition(study_, name) != kNone) return true;
    say_(line_of(key), key + " is " + printable(name) +
                           ", it must be the name of a condition: " + condition_names(study_));
    return false;
  }

  void check_measure() {
    const std::string key = "hypothesis.measure";
    if (is_refused_(key, index_)) return;
    if (!find(key)) {
      return say_(hypothesis_.line,
                  key + " is missing; it must be a metric of trials.csv, such as err_total_mm");
    }
    const auto columns = trial_metric_columns();
    const bool exists = std::any_of(columns.begin(), columns.end(), [this](const TrialColumn& c) {
      return c.name == hypothesis_.measure;
    });
    if (exists && !has_no_ratio(hypothesis_.measure)) return;
    if (exists) {
      return say_(line_of(key), key + " is " + printable(hypothesis_.measure) +
                                    ", which may be negative, or of which more is better");
    }
    say_(line_of(key), key + " is " + printable(hypothesis_.measure) +
                           ", it must be a metric of trials.csv: " + metric_names());
  }

  void check_margin() {
    if (is_refused_("hypothesis.kind", index_)) return;
    const TomlEntry* margin = find("hypothesis.margin");
    const bool needs = hypothesis_.kind != HypothesisKind::kLess;
    const std::string kind(kHypothesisKinds[static_cast<std::size_t>(hypothesis_.kind)]);
    if (needs && !margin) {
      say_(line_of("hypothesis.kind"),
           "hypothesis.margin is missing; the kind " + kind + " requires it, 0.01 to 1");
    } else if (margin && !needs) {
      say_(margin->line, "hypothesis.margin has no effect with the kind less");
    }
  }

  void check_session() {
    if (is_refused_("hypothesis.session", index_) || find_session(study_, hypothesis_)) return;
    if (hypothesis_.session) {
      const std::string name(kSessionKinds[static_cast<std::size_t>(*hypothesis_.session)]);
      return say_(line_of("hypothesis.session"), "hypothesis.session is \"" + name +
                                                     "\", it must be a session of the study that "
                                                     "has both conditions");
    }
    say_(line_of("hypothesis.against"), "hypothesis: no session has both " + hypothesis_.condition +
                                            " and " + hypothesis_.against);
  }

  /// Two equal hypotheses would count twice in the correction.
  void check_twice() {
    const auto key = [](const StudyHypothesis& h) {
      return std::tie(h.condition, h.against, h.measure, h.kind, h.session);
    };
    for (std::size_t i = 0; i < index_; ++i) {
      if (key(study_.hypotheses[i]) != key(hypothesis_)) continue;
      return say_(hypothesis_.line, "hypothesis is the same as the one in line " +
                                        std::to_string(study_.hypotheses[i].line));
    }
  }

  const Study& study_;
  const StudyHypothesis& hypothesis_;
  std::span<const TomlEntry> entries_;
  std::size_t index_;
  const IsRefused& is_refused_;
  const Say& say_;
};

}  // namespace

void check_hypotheses(const Study& study, std::span<const TomlEntry> entries,
                      const std::function<bool(std::string_view, std::size_t)>& is_refused,
                      const std::function<void(int, const std::string&)>& say) {
  for (std::size_t i = 0; i < study.hypotheses.size(); ++i) {
    // Parts without a line are not tables; the reader has reported them.
    if (study.hypotheses[i].line == 0) continue;
    HypothesisCheck(study, entries, i, is_refused, say).run();
  }
}

SessionKind hypothesis_session(const Study& study, const StudyHypothesis& hypothesis) {
  const std::optional<SessionKind> session = find_session(study, hypothesis);
  FELT_CHECK(session);
  return *session;
}

std::size_t condition_index(const Study& study, std::string_view name) {
  const std::size_t index = find_condition(study, name);
  FELT_CHECK(index != kNone);
  return index;
}

std::string hypothesis_text(const Study& study, const StudyHypothesis& hypothesis) {
  const std::string& condition =
      study.conditions[condition_index(study, hypothesis.condition)].label;
  const std::string& against = study.conditions[condition_index(study, hypothesis.against)].label;
  // Rounded to 1e-6 %, because 100 * 0.07 is not exactly 7.
  const std::string percent = number_text(std::round(1e8 * hypothesis.margin) / 1e6) + " %";
  switch (hypothesis.kind) {
    case HypothesisKind::kLess:
      break;
    case HypothesisKind::kNotWorse:
      return hypothesis.measure + " in \"" + condition + "\" is less than " + percent +
             " larger than in \"" + against + "\"";
    case HypothesisKind::kSame:
      return hypothesis.measure + " in \"" + condition + "\" and in \"" + against +
             "\" differs by less than " + percent;
  }
  return hypothesis.measure + " is smaller in \"" + condition + "\" than in \"" + against + "\"";
}

}  // namespace felt
