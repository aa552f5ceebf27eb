#pragma once

#include <string>
#include <vector>

#include "compiler/document/equations.h"
#include "compiler/document/page.h"

namespace compiler {

// A page that is written from above to below.
class PageBuilder {
 public:
  explicit PageBuilder(std::string title) { page_.title = std::move(title); }

  void Add(PageBlock block) { page_.blocks.push_back(std::move(block)); }
  void AddHeading(std::string text);
  void AddParagraph(Text text) { Add(Paragraph{std::move(text)}); }
  void AddFormulas(const std::vector<Equation>& equations);
  // Without the columns in which nothing stands.
  void AddTable(Table table);
  // With its heading, unless it has no rows.
  void AddSection(std::string heading, Table table);

  Page Finish() { return std::move(page_); }

 private:
  Page page_;
};

}  // namespace compiler
