#include "compiler/language_server/protocol.h"

#include "compiler/language_server/uri.h"
#include "compiler/language_server/workspace.h"

namespace compiler::protocol {

Json ToJson(TextPosition position) {
  return {{"line", position.line}, {"character", position.column}};
}

Json ToJson(const TextPositions& positions, Span span) {
  return {{"start", ToJson(positions.PositionOf(span.begin))},
          {"end", ToJson(positions.PositionOf(span.end))}};
}

TextPosition PositionFrom(const Json& json) {
  return {json.at("line").get<uint32_t>(), json.at("character").get<uint32_t>()};
}

Json LocationOf(const Sources& sources, Span span, PositionEncoding encoding) {
  const SourceFile& file = sources.FileOf(span);
  const TextPositions positions(file.text(), encoding);
  return {{"uri", UriOfPath(file.path())}, {"range", ToJson(positions, LocalSpan(file, span))}};
}

Json Markdown(const std::string& text) { return {{"kind", "markdown"}, {"value", text}}; }

}  // namespace compiler::protocol
