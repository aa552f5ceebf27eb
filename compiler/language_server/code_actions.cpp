#include "compiler/language_server/code_actions.h"

#include <algorithm>
#include <utility>

namespace compiler {
namespace {

using protocol::Json;

constexpr const char* kAnyKind = "";
constexpr const char* kQuickFix = "quickfix";

bool IsWanted(const Json& params) {
  const Json only = params.value(Json::json_pointer("/context/only"), Json());
  if (!only.is_array()) return true;
  return std::ranges::any_of(
      only, [](const Json& kind) { return kind == kAnyKind || kind == kQuickFix; });
}

std::pair<uint32_t, uint32_t> PlaceIn(const Json& position) {
  const TextPosition place = protocol::PositionFrom(position);
  return {place.line, place.column};
}

bool Touch(const Json& range, const Json& other) {
  return PlaceIn(range.at("start")) <= PlaceIn(other.at("end")) &&
         PlaceIn(other.at("start")) <= PlaceIn(range.at("end"));
}

Json ActionOf(const Json& fix, const Json& diagnostic, const std::string& uri) {
  const Json edit{{"range", fix["range"]}, {"newText", fix["newText"]}};
  return {{"title", fix["title"]},
          {"kind", kQuickFix},
          {"diagnostics", Json::array({diagnostic})},
          {"isPreferred", diagnostic["data"]["fixes"].size() == 1},
          {"edit", {{"changes", {{uri, Json::array({edit})}}}}}};
}

}  // namespace

Json CodeActions(const Json& diagnostics, const std::string& uri, const Json& params) {
  Json actions = Json::array();
  if (!IsWanted(params)) return actions;
  for (const Json& diagnostic : diagnostics) {
    if (!diagnostic.contains("data") || !Touch(diagnostic["range"], params.at("range"))) continue;
    for (const Json& fix : diagnostic["data"]["fixes"]) {
      actions.push_back(ActionOf(fix, diagnostic, uri));
    }
  }
  return actions;
}

}  // namespace compiler
