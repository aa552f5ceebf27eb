#include "compiler/language_server/signature_help.h"

#include <sstream>

#include "compiler/language_server/cursor_place.h"
#include "compiler/language_server/hover.h"

namespace compiler {
namespace {

using protocol::Json;

// The arguments of "near(d: real [m], reach: real [m]) -> real", one by one.
Json Parameters(const std::string& signature) {
  Json parameters = Json::array();
  const size_t begin = signature.find('(') + 1;
  const size_t end = signature.find(')', begin);
  std::istringstream list(signature.substr(begin, end - begin));
  for (std::string parameter; std::getline(list, parameter, ',');) {
    parameter.erase(0, parameter.find_first_not_of(' '));
    parameters.push_back({{"label", parameter}});
  }
  return parameters;
}

}  // namespace

Json SignatureHelp(const Document& document, uint32_t offset, Workspace& workspace) {
  const OpenCall call = FindOpenCall(document.tokens(), offset);
  if (call.function.empty()) return nullptr;
  Json signatures = Json::array();
  std::istringstream lines(SignatureOf(call.function, document, workspace));
  size_t active = 0;
  for (std::string signature; std::getline(lines, signature);) {
    Json parameters = Parameters(signature);
    if (parameters.size() <= call.argument && signatures.size() == active) ++active;
    signatures.push_back({{"label", signature}, {"parameters", std::move(parameters)}});
  }
  if (signatures.empty()) return nullptr;
  if (active >= signatures.size()) active = 0;
  return {{"signatures", std::move(signatures)},
          {"activeSignature", active},
          {"activeParameter", call.argument}};
}

}  // namespace compiler
