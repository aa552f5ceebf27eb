#include <algorithm>
#include <string_view>

#include "compiler/document/page.h"

namespace compiler {
namespace {

// As it is meant, whatever Markdown would see in it.
std::string EscapedMarkdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\*_[]<>|$").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string ToMarkdown(const Piece& piece) {
  switch (piece.face) {
    case Piece::kPlain:
      return EscapedMarkdown(piece.text);
    case Piece::kCode:
      return "`" + piece.text + "`";
    case Piece::kMath:
      return "$" + piece.text + "$";
    case Piece::kStrong:
      return "**" + EscapedMarkdown(piece.text) + "**";
  }
  return "";
}

std::string ToMarkdown(const Text& text) {
  std::string markdown;
  for (const Piece& piece : text) markdown += ToMarkdown(piece);
  return markdown;
}

// A row of a table is one line.
std::string ToCell(const Text& text) {
  std::string cell = ToMarkdown(text);
  std::ranges::replace(cell, '\n', ' ');
  return cell;
}

struct MarkdownWriter {
  std::string operator()(const Heading& heading) const {
    return std::string(static_cast<size_t>(heading.level), '#') + " " + ToMarkdown(heading.text) +
           "\n";
  }
  std::string operator()(const Paragraph& paragraph) const {
    return ToMarkdown(paragraph.text) + "\n";
  }
  std::string operator()(const Formulas& formulas) const {
    return "$$\n" + ToLatex(formulas) + "\n$$\n";
  }
  std::string operator()(const Table& table) const {
    std::string markdown = "|";
    for (const std::string& name : table.header) markdown += " " + name + " |";
    markdown += "\n|";
    for (size_t i = 0; i < table.header.size(); ++i) markdown += "---|";
    for (const auto& row : table.rows) {
      markdown += "\n|";
      for (const Text& cell : row) markdown += cell.empty() ? " |" : " " + ToCell(cell) + " |";
    }
    return markdown + "\n";
  }
  std::string operator()(const List& list) const {
    std::string markdown;
    for (const Text& item : list.items) markdown += "* " + ToMarkdown(item) + "\n";
    return markdown;
  }
  std::string operator()(const Automaton& automaton) const {
    return "```mermaid\n" + ToMermaid(automaton) + "```\n";
  }
};

}  // namespace

std::string ToMarkdown(const Page& page) {
  std::string markdown = "# " + EscapedMarkdown(page.title) + "\n";
  for (const PageBlock& block : page.blocks) markdown += "\n" + std::visit(MarkdownWriter{}, block);
  return markdown;
}

}  // namespace compiler
