// The phases of a task and the ways between them, to be drawn.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/analyze/analyze.h"
#include "compiler/check/transitions.h"

namespace compiler {

struct Automaton {
  // All transitions from one phase to another, with a label for each.
  struct Way {
    size_t from = 0;
    size_t to = 0;
    std::vector<std::string> labels;
  };
  std::vector<std::string> phases;  // an episode begins in the first
  std::vector<Way> ways;            // in the order of the text
};

// When a transition is taken, as the task's text says it: "contact[left_hand]", "after 3 s",
// "always".
std::string ConditionText(const Transition& transition, const Analysis& analysis);

// Of a task that has been checked and has phases.
Automaton AutomatonOf(const Analysis& analysis);

// A block of Mermaid for Markdown.
std::string ToMermaid(const Automaton& automaton);
// A drawing for a page; its colors are the page's.
std::string ToSvg(const Automaton& automaton);

// `text` inside of HTML or SVG.
std::string EscapedHtml(std::string_view text);

}  // namespace compiler
