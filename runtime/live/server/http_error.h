#pragma once

#include <string>

#include "runtime/base/user_error.h"

namespace runtime {

// A request that is answered with an error's status, such as 404.
class HttpError : public UserError {
 public:
  HttpError(unsigned status, std::string message)
      : UserError(std::move(message)), status_(status) {}
  unsigned status() const { return status_; }

 private:
  unsigned status_;
};

}  // namespace runtime
