// A mistake of ours, never of the user.
#pragma once

#include <exception>
#include <filesystem>
#include <string>
#include <utility>

namespace compiler {

class InternalError : public std::exception {
 public:
  // `evidence` is a folder with all that is needed to look into it.
  InternalError(std::string message, std::filesystem::path evidence)
      : message_(std::move(message)), evidence_(std::move(evidence)) {}
  const char* what() const noexcept override { return message_.c_str(); }
  const std::filesystem::path& evidence() const { return evidence_; }

 private:
  std::string message_;
  std::filesystem::path evidence_;
};

}  // namespace compiler
