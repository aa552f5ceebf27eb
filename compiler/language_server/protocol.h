// The protocol's own values: numbers that stand for kinds, places as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "compiler/language_server/text_positions.h"
#include "compiler/source/sources.h"

namespace compiler::protocol {

using Json = nlohmann::json;

enum CompletionKind {
  kCompleteFunction = 3,
  kCompleteVariable = 6,
  kCompleteProperty = 10,
  kCompleteUnit = 11,
  kCompleteKeyword = 14,
  kCompleteFile = 17,
  kCompleteEnumMember = 20,
  kCompleteConstant = 21,
  kCompleteEvent = 23,
  kCompleteType = 25
};

enum SymbolKind {
  kModule = 2,
  kMethod = 6,
  kProperty = 7,
  kField = 8,
  kEnum = 10,
  kFunction = 12,
  kVariable = 13,
  kConstant = 14,
  kKey = 20,
  kEvent = 24
};

enum ErrorCode {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kNotInitialized = -32002,
  kRequestFailed = -32803
};

Json ToJson(TextPosition position);
Json ToJson(const TextPositions& positions, Span span);  // a range
TextPosition PositionFrom(const Json& json);

// A place in one of the files of a task.
Json LocationOf(const Sources& sources, Span span, PositionEncoding encoding);

// A text with Markdown in it.
Json Markdown(const std::string& text);

}  // namespace compiler::protocol
