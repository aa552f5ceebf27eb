// A page of text, formulas and tables, before it becomes Markdown or HTML.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "compiler/document/automaton.h"

namespace compiler {

// A stretch of text in one face.
struct Piece {
  enum Face { kPlain, kCode, kMath, kStrong };  // kMath: LaTeX
  Face face = kPlain;
  std::string text;
};
using Text = std::vector<Piece>;

Text Plain(std::string text);
Text Code(std::string text);
Text Math(std::string latex);
// Text in which `code` stands between backticks, as authors write it.
Text FromDoc(const std::string& doc);

struct Heading {
  int level = 2;
  Text text;
};
struct Paragraph {
  Text text;
};
// Formulas below each other, aligned at `=` or the arrow.
struct Formulas {
  struct Line {
    std::string left;
    std::string sign;  // "=", "\\leftarrow"
    std::string right;
    std::string term{};                // the reward term that is paid this; "": none
    std::vector<std::string> reads{};  // names of what it is computed from (reads.h)
    std::string let{};                 // the let that it is the value of; "": none
  };
  std::vector<Line> lines;
};
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<Text>> rows;  // as many cells as the header
};
struct List {
  std::vector<Text> items;
};

using PageBlock = std::variant<Heading, Paragraph, Formulas, Table, List, Automaton>;

struct Page {
  std::string title;
  std::vector<PageBlock> blocks;
};

// The formulas as one LaTeX environment.
std::string ToLatex(const Formulas& formulas);

std::string ToMarkdown(const Page& page);

// One file that needs no network. `page_template` comes from share/taskc/document/template.html.
std::string ToHtml(const Page& page, const std::string& page_template);

}  // namespace compiler
