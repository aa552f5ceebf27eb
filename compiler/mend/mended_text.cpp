#include "compiler/mend/mended_text.h"

namespace compiler {

std::vector<Fix> Apart(const std::vector<Fix>& fixes) {
  std::vector<Fix> apart;
  for (const Fix& fix : fixes) {
    if (apart.empty() || apart.back().span.end < fix.span.begin) apart.push_back(fix);
  }
  return apart;
}

std::string WithFixes(const SourceFile& file, const std::vector<Fix>& fixes) {
  std::string text;
  uint32_t copied = file.first_offset();
  for (const Fix& fix : fixes) {
    text.append(file.TextOf({copied, fix.span.begin})).append(fix.text);
    copied = fix.span.end;
  }
  return text.append(file.TextOf({copied, file.end_offset()}));
}

}  // namespace compiler
