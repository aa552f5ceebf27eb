#include <string_view>

#include "compiler/document/automaton.h"
#include "compiler/document/page.h"

namespace compiler {
namespace {

std::string Element(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name.substr(0, name.find(' ')) + ">";
}

std::string ToHtml(const Piece& piece) {
  const std::string text = EscapedHtml(piece.text);
  switch (piece.face) {
    case Piece::kPlain:
      return text;
    case Piece::kCode:
      return Element("code", text);
    case Piece::kMath:
      return Element("span class=\"math\"", text);
    case Piece::kStrong:
      return Element("strong", text);
  }
  return "";
}

std::string ToHtml(const Text& text) {
  std::string html;
  for (const Piece& piece : text) html += ToHtml(piece);
  return html;
}

struct HtmlWriter {
  std::string operator()(const Heading& heading) const {
    return Element("h" + std::to_string(heading.level), ToHtml(heading.text));
  }
  std::string operator()(const Paragraph& paragraph) const {
    return Element("p", ToHtml(paragraph.text));
  }
  std::string operator()(const Formulas& formulas) const {
    return Element("div class=\"math\"", EscapedHtml(ToLatex(formulas)));
  }
  std::string operator()(const Table& table) const {
    std::string head, body;
    for (const std::string& name : table.header) head += Element("th", EscapedHtml(name));
    for (const auto& row : table.rows) {
      std::string cells;
      for (const Text& cell : row) cells += Element("td", ToHtml(cell));
      body += "\n" + Element("tr", cells);
    }
    return Element("div class=\"scroll\"", Element("table", Element("thead", Element("tr", head)) +
                                                                Element("tbody", body)));
  }
  std::string operator()(const List& list) const {
    std::string items;
    for (const Text& item : list.items) items += "\n" + Element("li", ToHtml(item));
    return Element("ul", items + "\n");
  }
  std::string operator()(const Automaton& automaton) const {
    return Element("div class=\"scroll\"", ToSvg(automaton));
  }
};

void Replace(std::string& text, std::string_view mark, std::string_view with) {
  const size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), with);
}

}  // namespace

std::string EscapedHtml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string ToHtml(const Page& page, const std::string& page_template) {
  std::string content = Element("h1", EscapedHtml(page.title)) + "\n";
  for (const PageBlock& block : page.blocks) content += std::visit(HtmlWriter{}, block) + "\n";
  std::string html = page_template;
  Replace(html, "{{title}}", EscapedHtml(page.title));
  Replace(html, "{{content}}", content);
  return html;
}

}  // namespace compiler
