#include "compiler/language_server/document_symbols.h"

#include <optional>

namespace compiler {
namespace {

using protocol::Json;

// Nothing for names that are too many for an outline.
std::optional<protocol::SymbolKind> SymbolKindOf(NameKind kind) {
  switch (kind) {
    case NameKind::kTask:
      return protocol::kModule;
    case NameKind::kSensor:
      return protocol::kField;
    case NameKind::kParam:
    case NameKind::kConst:
    case NameKind::kTable:
      return protocol::kConstant;
    case NameKind::kSet:
      return protocol::kEnum;
    case NameKind::kMemory:
    case NameKind::kGoal:
      return protocol::kVariable;
    case NameKind::kObservation:
    case NameKind::kMetric:
    case NameKind::kTerm:
    case NameKind::kLog:
      return protocol::kKey;
    case NameKind::kEvent:
    case NameKind::kPhase:
      return protocol::kEvent;
    case NameKind::kTest:
      return protocol::kMethod;
    case NameKind::kFunction:
      return protocol::kFunction;
    case NameKind::kArgument:
    case NameKind::kLet:
    case NameKind::kLoop:
      break;
  }
  return std::nullopt;
}

bool IsPartOfEvent(NameKind kind) { return kind == NameKind::kTerm || kind == NameKind::kLog; }

}  // namespace

Json DocumentSymbols(const Document& document) {
  Json symbols = Json::array();
  uint32_t end_of_event = 0;
  for (const DeclaredName& name : document.names()) {
    const auto kind = SymbolKindOf(name.kind);
    if (!kind) continue;
    Json symbol{{"name", name.name},
                {"kind", *kind},
                {"range", protocol::ToJson(document.positions(), name.whole)},
                {"selectionRange", protocol::ToJson(document.positions(), name.span)}};
    if (!name.type.empty()) symbol["detail"] = name.type;
    // Terms and logs belong to the event or phase in which they stand first.
    const bool has_event = name.span.begin < end_of_event;
    if (*kind == protocol::kEvent) end_of_event = name.whole.end;
    if (IsPartOfEvent(name.kind) && has_event) {
      Json& children = symbols.back()["children"];
      bool is_known = false;
      for (const Json& child : children) is_known = is_known || child["name"] == name.name;
      if (!is_known) children.push_back(std::move(symbol));
    } else {
      symbols.push_back(std::move(symbol));
    }
  }
  return symbols;
}

}  // namespace compiler
