#include "runtime/live/server/access.h"

#include <fmt/format.h>

#include "runtime/live/server/http_error.h"

namespace runtime {
namespace {

constexpr std::string_view kBearer = "Bearer ";
constexpr std::string_view kHttp = "http://";

}  // namespace

void Access::Check(const Caller& caller) const {
  // A page elsewhere may have a name that leads to this machine: then its browser sends that name.
  if (!IsOurHost(caller.host)) {
    throw HttpError(403, fmt::format("the host must be 127.0.0.1:{0} or localhost:{0}", port_));
  }
  if (!caller.origin.empty() &&
      !(caller.origin.starts_with(kHttp) && IsOurHost(caller.origin.substr(kHttp.size())))) {
    throw HttpError(403, "pages of other origins may not talk to the trainer");
  }
  const bool is_bearer = caller.authorization.starts_with(kBearer);
  if (IsOurToken(is_bearer ? caller.authorization.substr(kBearer.size()) : caller.token)) return;
  throw HttpError(401,
                  "the token is missing or wrong; it is in control.json in the run's folder, and "
                  "belongs in the header `Authorization: Bearer TOKEN`");
}

bool Access::IsOurHost(std::string_view host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

// Takes as long for a token that is almost right as for any other of its length.
bool Access::IsOurToken(std::string_view token) const {
  if (token.size() != token_.size()) return false;
  unsigned char difference = 0;
  for (size_t i = 0; i < token.size(); ++i) {
    difference |= static_cast<unsigned char>(token[i] ^ token_[i]);
  }
  return difference == 0;
}

}  // namespace runtime
