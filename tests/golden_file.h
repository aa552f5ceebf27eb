// A file that holds the input of a test and, behind it, what is expected of it. What is expected
// stands there as comments, so that the whole file can be tried by hand:
//
//     task hop
//     metric height = hight
//     // ==== expected
//     // error[E0201]: there is nothing called `hight`
//
// A `.txt` has no comments: there it stands as it is.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace golden {

inline std::string_view CommentMark(const std::filesystem::path& file) {
  if (file.extension() == ".task") return "//";
  if (file.extension() == ".toml") return "#";
  return "";
}

// A text as it stands behind the input of this file, with the heading. Different texts stay
// different, also where only blanks or the last line end differ.
inline std::string Section(const std::filesystem::path& file, std::string_view text) {
  const std::string_view mark = CommentMark(file);
  std::string section;
  bool begins = true;
  for (const char c : "==== expected\n" + std::string(text)) {
    if (begins) section += mark;
    if (begins && !mark.empty() && c != '\n') section += ' ';
    section += c;
    begins = c == '\n';
  }
  return section;
}

struct Parts {
  std::string input;
  std::string section;  // what is expected, with its heading; empty where there is none
};

inline Parts Split(const std::filesystem::path& file, const std::string& text) {
  const size_t end = std::min(("\n" + text).find("\n" + Section(file, "")), text.size());
  return {text.substr(0, end), text.substr(end)};
}

}  // namespace golden
