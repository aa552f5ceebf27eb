#include "compiler/report/report.h"

namespace compiler {

FileRange RangeOf(const Sources& sources, Span span) {
  const SourceFile& source = sources.FileOf(span);
  const uint32_t first = source.first_offset();
  return {source.path(),
          source.PositionOf(span.begin),
          source.PositionOf(span.end),
          {span.begin - first, span.end - first}};
}

void RunReport::Add(const Sources& sources, const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    Finding finding{diagnostic, RangeOf(sources, diagnostic.span), {}, {}};
    for (const Label& label : diagnostic.labels) {
      finding.label_places.push_back(RangeOf(sources, label.span));
    }
    for (const Fix& fix : diagnostic.help.fixes) {
      finding.fix_places.push_back(RangeOf(sources, fix.span));
    }
    findings.push_back(std::move(finding));
  }
}

std::string ToText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace compiler
