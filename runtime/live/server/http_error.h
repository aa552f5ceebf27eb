#pragma once

#include <string>

#include "runtime/base/user_error.h"

namespace runtime {

// Gives the request a response with an error status, such as 404.
class HttpError : public UserError {
 public:
  HttpError(unsigned status, std::string message)
      : UserError(std::move(message)), status_(status) {}
  unsigned status() const { return status_; }

 private:
  unsigned status_;
};

}  // namespace runtime
