// Joins each `allow` with what stands below it.
#pragma once

#include <TaskParser.h>

#include <vector>

#include "compiler/syntax/syntax_report.h"
#include "compiler/syntax/syntax_tree.h"

namespace compiler {

class Allowances {
 public:
  explicit Allowances(SyntaxReport& report) : report_(report) {}

  void Add(grammar::TaskParser::AllowContext& context);
  // What has been added since the last call holds for `covers`.
  void Attach(Span covers);
  // At the end of a block or file: reports what nothing follows.
  void End();
  std::vector<Allowance> Take() { return std::move(attached_); }

 private:
  struct Pending {
    std::vector<Identifier> codes;
    Span span;
  };

  SyntaxReport& report_;
  std::vector<Pending> pending_;
  std::vector<Allowance> attached_;
};

}  // namespace compiler
