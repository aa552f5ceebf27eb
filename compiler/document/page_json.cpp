#include "compiler/document/page_json.h"

namespace compiler {
namespace {

const char* FaceName(Piece::Face face) {
  switch (face) {
    case Piece::kPlain:
      return "plain";
    case Piece::kCode:
      return "code";
    case Piece::kMath:
      return "math";
    case Piece::kStrong:
      return "strong";
  }
  return "";
}

nlohmann::json PiecesOf(const Text& text) {
  nlohmann::json pieces = nlohmann::json::array();
  for (const Piece& piece : text) {
    pieces.push_back({{"face", FaceName(piece.face)}, {"text", piece.text}});
  }
  return pieces;
}

struct BlockWriter {
  nlohmann::json operator()(const Heading& heading) const {
    return {{"kind", "heading"}, {"level", heading.level}, {"text", PiecesOf(heading.text)}};
  }
  nlohmann::json operator()(const Paragraph& paragraph) const {
    return {{"kind", "paragraph"}, {"text", PiecesOf(paragraph.text)}};
  }
  nlohmann::json operator()(const Formulas& formulas) const {
    nlohmann::json lines = nlohmann::json::array();
    for (const Formulas::Line& line : formulas.lines) {
      nlohmann::json& json = lines.emplace_back(
          nlohmann::json{{"left", line.left}, {"sign", line.sign}, {"right", line.right}});
      if (!line.term.empty()) json["term"] = line.term;
      if (!line.reads.empty()) json["reads"] = line.reads;
      if (!line.let.empty()) json["let"] = line.let;
    }
    return {{"kind", "formulas"}, {"lines", std::move(lines)}};
  }
  nlohmann::json operator()(const Table& table) const {
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& row : table.rows) {
      nlohmann::json& cells = rows.emplace_back(nlohmann::json::array());
      for (const Text& cell : row) cells.push_back(PiecesOf(cell));
    }
    return {{"kind", "table"}, {"header", table.header}, {"rows", std::move(rows)}};
  }
  nlohmann::json operator()(const List& list) const {
    nlohmann::json items = nlohmann::json::array();
    for (const Text& item : list.items) items.push_back(PiecesOf(item));
    return {{"kind", "list"}, {"items", std::move(items)}};
  }
  nlohmann::json operator()(const Automaton& automaton) const {
    nlohmann::json ways = nlohmann::json::array();
    for (const Automaton::Way& way : automaton.ways) {
      ways.push_back({{"from", automaton.phases[way.from]},
                      {"to", automaton.phases[way.to]},
                      {"labels", way.labels}});
    }
    return {{"kind", "automaton"}, {"phases", automaton.phases}, {"ways", std::move(ways)}};
  }
};

}  // namespace

nlohmann::json ToJson(const Page& page) {
  nlohmann::json blocks = nlohmann::json::array();
  for (const PageBlock& block : page.blocks) blocks.push_back(std::visit(BlockWriter{}, block));
  return {{"title", page.title}, {"blocks", std::move(blocks)}};
}

}  // namespace compiler
