// Who may talk to the trainer over HTTP: programs of the run's owner, which know the token, and no
// page of another origin in their browser.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace runtime {

// What a request says of its sender.
struct Caller {
  std::string_view host;           // header Host
  std::string_view origin;         // header Origin; "" where none was sent
  std::string_view authorization;  // header Authorization
  std::string_view token;          // in the address, where a token may stand there
};

class Access {
 public:
  Access(uint16_t port, std::string token) : port_(port), token_(std::move(token)) {}

  // Throws HttpError 401 or 403.
  void Check(const Caller& caller) const;

 private:
  bool IsOurHost(std::string_view host) const;
  bool IsOurToken(std::string_view token) const;

  uint16_t port_;
  std::string token_;
};

}  // namespace runtime
