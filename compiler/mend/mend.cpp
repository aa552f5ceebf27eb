#include "compiler/mend/mend.h"

#include <unistd.h>

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/analyze/analyze.h"
#include "compiler/compose/library.h"
#include "compiler/mend/mended_text.h"

namespace compiler {
namespace {

using Texts = std::map<std::string, std::string>;

// Fixes mend what other fixes bring to light, but not for ever.
constexpr int kMaxRounds = 20;
constexpr int kMaxTrials = 500;

struct Candidate {
  Fix fix;
  Diagnostic error;
};

// A task as it would be with some texts in place of those of its files.
class Mender {
 public:
  Mender(const std::filesystem::path& file, const FileReader& read,
         const std::filesystem::path& robots,
         const std::function<bool(const std::string&)>& may_change)
      : file_(file), read_(read), robots_(robots), may_change_(may_change) {}

  Mending Run() {
    const size_t errors = AnalyzeWith({}).diagnostics.error_count();
    if (errors == 0) return {};
    Mending all = AllAtOnce();
    return AnalyzeWith(all.texts).diagnostics.error_count() <= errors ? all : OneByOne();
  }

 private:
  Analysis AnalyzeWith(const Texts& texts) const {
    const auto read = [&](const std::filesystem::path& path) {
      const auto changed = texts.find(path.string());
      return changed != texts.end() ? std::optional(changed->second) : read_(path);
    };
    return Analyze(file_, read, robots_);
  }

  // In the order of their places.
  std::vector<Candidate> CandidatesOf(const Analysis& analysis) const {
    std::vector<Candidate> candidates;
    for (const Diagnostic& diagnostic : analysis.diagnostics.list()) {
      if (diagnostic.severity != Severity::kError || diagnostic.help.fixes.size() != 1) continue;
      const Fix& fix = diagnostic.help.fixes.front();
      if (!may_change_(analysis.sources.FileOf(fix.span).path())) continue;
      candidates.push_back({fix, diagnostic});
    }
    std::ranges::stable_sort(candidates, {},
                             [](const Candidate& candidate) { return candidate.fix.span.begin; });
    return candidates;
  }

  static void Apply(const std::vector<Candidate>& candidates, const Sources& sources,
                    Mending& mending) {
    for (const SourceFile& file : sources.files()) {
      std::vector<Fix> fixes;
      std::vector<Candidate> of_file;
      for (const Candidate& candidate : candidates) {
        if (&sources.FileOf(candidate.fix.span) != &file) continue;
        fixes.push_back(candidate.fix);
        of_file.push_back(candidate);
      }
      if (fixes.empty()) continue;
      const std::vector<Fix> applied = Apart(fixes);
      for (const Fix& fix : applied) {
        const auto is_its = [&](const Candidate& other) { return other.fix.span == fix.span; };
        const Diagnostic& error = std::ranges::find_if(of_file, is_its)->error;
        mending.mended.push_back({file.path(), file.PositionOf(fix.span.begin), error.code,
                                  error.message, std::string(file.TextOf(fix.span)), fix.text});
      }
      mending.texts[file.path()] = WithFixes(file, applied);
    }
  }

  Mending AllAtOnce() const {
    Mending mending;
    std::set<Texts> seen;
    for (int round = 0; round < kMaxRounds && seen.insert(mending.texts).second; ++round) {
      const Analysis analysis = AnalyzeWith(mending.texts);
      const std::vector<Candidate> candidates = CandidatesOf(analysis);
      if (candidates.empty()) break;
      Apply(candidates, analysis.sources, mending);
    }
    return mending;
  }

  Mending OneByOne() const {
    Mending mending;
    std::set<Texts> seen = {mending.texts};
    int trials = 0;
    for (bool is_better = true; is_better;) {
      is_better = false;
      const Analysis analysis = AnalyzeWith(mending.texts);
      const size_t errors = analysis.diagnostics.error_count();
      for (const Candidate& candidate : CandidatesOf(analysis)) {
        if (++trials > kMaxTrials) return mending;
        Mending trial = mending;
        Apply({candidate}, analysis.sources, trial);
        if (!seen.insert(trial.texts).second) continue;
        if (AnalyzeWith(trial.texts).diagnostics.error_count() > errors) continue;
        mending = std::move(trial);
        is_better = true;
        break;
      }
    }
    return mending;
  }

  const std::filesystem::path& file_;
  const FileReader& read_;
  const std::filesystem::path& robots_;
  const std::function<bool(const std::string&)>& may_change_;
};

}  // namespace

Mending Mend(const std::filesystem::path& file, const FileReader& read,
             const std::filesystem::path& robots,
             const std::function<bool(const std::string& file)>& may_change) {
  return Mender(file, read, robots, may_change).Run();
}

bool IsOwnFile(const std::string& file) {
  return !IsOfLibrary(file) && access(file.c_str(), W_OK) == 0;
}

}  // namespace compiler
