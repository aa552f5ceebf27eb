#include "compiler/document/page.h"

namespace compiler {

Text Plain(std::string text) { return {{Piece::kPlain, std::move(text)}}; }
Text Code(std::string text) { return {{Piece::kCode, std::move(text)}}; }
Text Math(std::string latex) { return {{Piece::kMath, std::move(latex)}}; }

Text FromDoc(const std::string& doc) {
  Text text;
  size_t begin = 0;
  for (bool is_code = false; begin <= doc.size(); is_code = !is_code) {
    size_t end = doc.find('`', begin);
    if (end == std::string::npos) end = doc.size();
    if (end > begin) {
      text.push_back({is_code ? Piece::kCode : Piece::kPlain, doc.substr(begin, end - begin)});
    }
    begin = end + 1;
  }
  return text;
}

std::string ToLatex(const Formulas& formulas) {
  std::string latex = "\\begin{aligned}\n";
  for (const Formulas::Line& line : formulas.lines) {
    latex += line.left + " &" + line.sign + " " + line.right;
    latex += &line == &formulas.lines.back() ? "\n" : " \\\\[4pt]\n";
  }
  return latex + "\\end{aligned}";
}

}  // namespace compiler
