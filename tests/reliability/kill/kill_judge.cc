// The process that checks the result. It replays the samples that the killed process measured in a
// reference session. The recovered document must equal the document of that session at some moment
// in the last 50 ms.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <optional>

#include "felt/autosave/recovery.h"
#include "felt/session/session.h"
#include "felt/tools/tool.h"
#include "tests/reliability/kill/kill_shared.h"

namespace felt::kill {
namespace {

constexpr std::uint32_t kMaxLag = 500;  // samples

/// All samples that the haptic loop passed on to the edit thread. It may have read the last one
/// without passing it on.
struct Ink {
  std::vector<PenSample> samples;
  std::vector<std::int64_t> made_ns;
};

Ink ink_of(const Testimony& testimony) {
  Ink ink;
  const std::uint32_t read = testimony.read.load(), confirmed = testimony.confirmed.load();
  for (std::uint32_t k = 0; k < read; ++k) {
    const Tick& tick = testimony.ticks[k];
    if (k < confirmed && !tick.is_ink) continue;
    ink.samples.push_back(tick.sample);
    ink.samples.back().time_ns += kOffsetNs;
    ink.made_ns.push_back(tick.made_ns);
  }
  return ink;
}

/// Returns the age, in ns, of the oldest lost sample if the first `kept` samples were recovered.
std::int64_t age_of(const Ink& ink, std::uint32_t kept) {
  return kept == ink.samples.size() ? 0 : ink.made_ns.back() - ink.made_ns[kept];
}

class Reference {
 public:
  Reference(const Picture& picture, const Ink& ink) : picture_(picture), ink_(ink) {
    SessionOptions options;
    options.device = device_of(picture).capabilities;
    options.document = base_document(picture);
    session_.emplace(make_tools(), std::move(options));
  }

  /// Applies the user's events that precede the next sample, and returns true if any exist. Does
  /// nothing if the next sample is number `until` or later, because the edit thread had stopped.
  bool do_events(std::uint32_t until = UINT32_MAX) {
    if (next_ >= std::min(picture_.hangs_at, until)) return false;
    bool any = false;
    const std::int64_t now_ns = next_ == 0 ? kOffsetNs : ink_.samples[next_ - 1].time_ns;
    for (auto& what : events_at(picture_.seed, next_)) {
      static_cast<void>(session_->apply({now_ns, std::move(what)}));
      any = true;
    }
    return any;
  }
  void sample() { static_cast<void>(session_->sample(ink_.samples[next_++])); }
  /// Returns the number of samples processed so far.
  [[nodiscard]] std::uint32_t reported() const { return next_; }
  [[nodiscard]] bool is_over() const { return next_ == ink_.samples.size(); }
  [[nodiscard]] Session& session() { return *session_; }

 private:
  const Picture& picture_;
  const Ink& ink_;
  std::optional<Session> session_;
  std::uint32_t next_ = 0;
};

/// Returns the document after `told` samples with the active gesture finished. Applies only the
/// user's events that precede sample number `until`.
Document ended_after(const Picture& picture, const Ink& ink, std::uint32_t reported,
                     std::uint32_t until) {
  Reference reference(picture, ink);
  while (reference.reported() < reported) {
    reference.do_events(until);
    reference.sample();
  }
  reference.do_events(until);
  static_cast<void>(reference.session().finish());
  return reference.session().document();
}

/// Returns the last moment, as a number of samples, at which the session had this document and no
/// active gesture, or nullopt if it never had.
std::optional<std::uint32_t> last_time_of(const Document& document, const Picture& picture,
                                          const Ink& ink) {
  Reference reference(picture, ink);
  std::optional<std::uint32_t> last;
  std::uint64_t seen = UINT64_MAX;
  bool is_same = false;
  const auto look = [&] {
    if (reference.session().edit_count() != seen) {
      seen = reference.session().edit_count();
      is_same = reference.session().document() == document;
    }
    if (is_same && !reference.session().gesture_in_progress()) last = reference.reported();
  };
  look();
  for (;;) {
    if (reference.do_events()) look();
    if (reference.is_over()) return last;
    reference.sample();
    look();
  }
}

/// Describes the last tool and the events, gestures and edits by sample number, for a failure
/// message: e = event, g = start or end of a gesture, E = edit.
std::string scene_of(const Picture& picture, const Ink& ink) {
  Reference reference(picture, ink);
  std::string events;
  while (!reference.is_over()) {
    const bool was = reference.session().gesture_in_progress();
    const std::uint64_t edits = reference.session().edit_count();
    if (reference.do_events()) events += " e" + std::to_string(reference.reported());
    reference.sample();
    if (was != reference.session().gesture_in_progress())
      events += " g" + std::to_string(reference.reported());
    if (edits != reference.session().edit_count())
      events += " E" + std::to_string(reference.reported());
  }
  return std::string(reference.session().tool().info().id) + events;
}

std::uint32_t reported_until(const Ink& ink, std::int64_t time_ns) {
  std::uint32_t count = 0;
  while (count < ink.samples.size() && ink.samples[count].time_ns <= time_ns) ++count;
  return count;
}

struct Verdict {
  bool is_good = false;
  std::string reason;
  std::int64_t age_ns = 0;
};

Verdict bad(std::string reason) {
  return {false, std::move(reason), 0};
}

/// Returns the moment, as a number of samples, at which the session had the recovered drawing, or
/// nullopt if it never had.
std::optional<std::uint32_t> moment_of(const Recovered& recovered, const Picture& picture,
                                       const Ink& ink) {
  const Document& document = recovered.drawing.document;
  if (recovered.last_sample_ns >= 0) {
    const std::uint32_t reported = reported_until(ink, recovered.last_sample_ns);
    // The haptic loop may be ahead of the edit thread, which then has not yet applied the latest
    // events. So try without them, up to kMaxLag samples back.
    for (std::uint32_t until = reported + 1;;) {
      if (ended_after(picture, ink, reported, until) == document) return reported;
      do {
        if (until-- == 0 || reported - until > kMaxLag) return last_time_of(document, picture, ink);
      } while (events_at(picture.seed, until).empty());
    }
  }
  return last_time_of(document, picture, ink);
}

Verdict compare(const Recovered& recovered, const Picture& picture, const Testimony& testimony) {
  for (const std::string& problem : recovered.problems) {
    // A large file that was just opened may not be in the autosave yet. The file itself still holds
    // the drawing.
    const bool is_young = problem.find("not been copied completely") != std::string::npos;
    if (!is_young) return bad("problem: " + problem);
  }
  const Ink ink = ink_of(testimony);
  const bool is_empty = recovered.edits == 0 && !recovered.has_changes;
  if (is_empty && !testimony.has_store)
    return {true, {}, age_of(ink, 0)};  // killed during its first commit
  const std::optional<std::uint32_t> moment = moment_of(recovered, picture, ink);
  if (!moment) {
    return bad("there was never such a drawing (" +
               std::to_string(recovered.drawing.document.stroke_count()) + " strokes, " +
               std::to_string(ink.samples.size()) + " samples, until " +
               std::to_string(recovered.last_sample_ns) + ") " + scene_of(picture, ink));
  }
  const std::uint32_t kept = reported_until(ink, testimony.committed_ns.load());
  if (*moment < kept) {
    return bad("what was committed is lost: " + std::to_string(kept - *moment) + " samples of " +
               std::to_string(kept) + " of " + std::to_string(ink.samples.size()) + ", until " +
               std::to_string(recovered.last_sample_ns) + ": " + scene_of(picture, ink));
  }
  return {true, {}, age_of(ink, *moment)};
}

/// Checks the saved file if it exists: it must be readable and equal the document at some moment.
Verdict look_at_file(const Picture& picture, const Testimony& testimony) {
  if (::access(picture.save_path.c_str(), F_OK) != 0) return {true, {}, 0};
  const Result<Drawing> saved = read_felt(picture.save_path);
  if (!saved) return bad("the saved file: " + saved.error().message);
  if (saved->document == base_document(picture)) return {true, {}, 0};
  // The document may have been copied for the save in the middle of a gesture.
  const Ink ink = ink_of(testimony);
  Reference reference(picture, ink);
  while (!reference.is_over()) {
    reference.do_events();
    if (reference.session().document() == saved->document) return {true, {}, 0};
    reference.sample();
    if (reference.session().document() == saved->document) return {true, {}, 0};
  }
  return bad("the saved file is a drawing that never was");
}

Verdict look(const Picture& picture, std::int64_t process, Testimony& testimony) {
  const std::string owner = "/" + std::to_string(process) + "-";
  std::vector<AbandonedAutosave> found = find_abandoned_autosaves({picture.root});
  for (const AbandonedAutosave& store : found) {
    if (store.folder.find(owner) == std::string::npos) continue;
    const Result<Recovered> recovered = recover_autosave(store.folder);
    if (!recovered) return bad(recovered.error().message);
    testimony.strokes = static_cast<int>(recovered->drawing.document.stroke_count());
    testimony.live_samples = recovered->last_sample_ns >= 0 ? 1 : 0;
    const Verdict verdict = compare(*recovered, picture, testimony);
    return verdict.is_good ? Verdict{true, {}, verdict.age_ns} : verdict;
  }
  if (testimony.has_store) return bad("its store is gone");
  return {true, {}, age_of(ink_of(testimony), 0)};
}

}  // namespace

void judge(const Picture& picture, std::int64_t process, Testimony& testimony) {
  Verdict verdict = look(picture, process, testimony);
  if (verdict.is_good) {
    const Verdict file = look_at_file(picture, testimony);
    if (!file.is_good) verdict = file;
  }
  testimony.is_good = verdict.is_good;
  testimony.age_ns = verdict.age_ns;
  std::snprintf(testimony.reason.data(), testimony.reason.size(), "%s", verdict.reason.c_str());
  testimony.is_judged = true;
}

}  // namespace felt::kill
