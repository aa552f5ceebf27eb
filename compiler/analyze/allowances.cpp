#include "compiler/analyze/allowances.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace compiler {
namespace {

class AllowanceFilter {
 public:
  AllowanceFilter(const std::vector<Allowance>& allowances, const Sources& sources)
      : allowances_(allowances), sources_(sources) {}

  // Does an `allow` around it name its code? All that do are of use.
  bool Silences(const Diagnostic& diagnostic) {
    bool is_silenced = false;
    for (const Allowance& allowance : allowances_)
      for (const Identifier& code : allowance.codes) {
        if (code.text != diagnostic.code || !Covers(allowance, diagnostic.span)) continue;
        used_.insert(&code);
        is_silenced = true;
      }
    return is_silenced;
  }

  // Warnings for the codes that were of no use so far: of W0710 itself, or of all others.
  std::vector<Diagnostic> Useless(bool of_itself) const {
    std::vector<Diagnostic> useless;
    for (const Allowance& allowance : allowances_)
      for (const Identifier& code : allowance.codes) {
        if (used_.contains(&code) || (code.text == code::kUselessAllow) != of_itself) continue;
        if (sources_.IndexOf(code.span) != 0) continue;
        useless.push_back(MakeDiagnostic(code::kUselessAllow, code.span,
                                         fmt::format("there is no {} here to allow", code.text)));
        useless.back().help = {"remove it", {Without(code, allowance)}};
      }
    return useless;
  }

 private:
  // The one code with its comma or, where there is no other, the whole line.
  Fix Without(const Identifier& code, const Allowance& allowance) const {
    const auto index = static_cast<size_t>(&code - allowance.codes.data());
    if (index > 0) return {{allowance.codes[index - 1].span.end, code.span.end}, ""};
    if (allowance.codes.size() > 1) return {{code.span.begin, allowance.codes[1].span.begin}, ""};
    const SourceFile& file = sources_.main();
    const uint32_t line = file.LineOf(code.span.begin);
    const bool is_last = line == file.line_count();
    return {{file.LineStart(line), is_last ? file.end_offset() : file.LineStart(line + 1)}, ""};
  }

  // It also covers itself, for what is said of its own codes.
  static bool Covers(const Allowance& allowance, Span place) {
    const Span& covers = allowance.covers;
    return (covers.begin <= place.begin && place.begin < covers.end) ||
           std::ranges::any_of(allowance.codes,
                               [place](const Identifier& code) { return code.span == place; });
  }

  const std::vector<Allowance>& allowances_;
  const Sources& sources_;
  std::set<const Identifier*> used_;
};

}  // namespace

Diagnostics ApplyAllowances(const std::vector<Allowance>& allowances, const Sources& sources,
                            const Diagnostics& found) {
  Diagnostics left;
  AllowanceFilter filter(allowances, sources);
  for (const Diagnostic& diagnostic : found.list()) {
    const bool is_warning = diagnostic.severity == Severity::kWarning;
    const bool is_own = sources.IndexOf(diagnostic.span) == 0;
    if (!is_warning || (is_own && !filter.Silences(diagnostic))) left.Add(diagnostic);
  }
  // `allow W0710` may silence what is said of other codes, and only then be useless itself.
  for (const bool of_itself : {false, true})
    for (Diagnostic& useless : filter.Useless(of_itself))
      if (of_itself || !filter.Silences(useless)) left.Add(std::move(useless));
  return left;
}

}  // namespace compiler
