#pragma once

#include <exception>
#include <string>
#include <utility>

namespace runtime {

// A mistake of the user: a wrong name, type, value or file. The message says what to do.
class UserError : public std::exception {
 public:
  explicit UserError(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

}  // namespace runtime
