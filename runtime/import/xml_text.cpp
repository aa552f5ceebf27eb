#include "runtime/import/xml_text.h"

#include <algorithm>
#include <cctype>

namespace runtime {
namespace {

bool IsSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// Behind the end of a comment, a declaration or CDATA that begins here; `begin` where none does.
size_t SkipOther(std::string_view text, size_t begin) {
  const auto behind = [&](std::string_view end) {
    const size_t found = text.find(end, begin);
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  if (text.substr(begin).starts_with("<!--")) return behind("-->");
  if (text.substr(begin).starts_with("<![CDATA[")) return behind("]]>");
  if (text.substr(begin).starts_with("<?")) return behind("?>");
  if (text.substr(begin).starts_with("<!")) return behind(">");
  return begin;
}

// Behind the `>` of a tag; one within quotes is none.
size_t EndOfTag(std::string_view text, size_t begin) {
  char quote = 0;
  for (size_t i = begin; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i + 1;
    }
  }
  return text.size();
}

}  // namespace

std::vector<XmlTag> XmlText::Tags() const {
  std::vector<XmlTag> tags;
  for (size_t i = text_.find('<'); i != std::string::npos; i = text_.find('<', i)) {
    if (const size_t behind = SkipOther(text_, i); behind != i) {
      i = behind;
      continue;
    }
    XmlTag tag = {.begin = i, .end = EndOfTag(text_, i), .name = {}};
    tag.is_end = i + 1 < text_.size() && text_[i + 1] == '/';
    tag.is_empty = tag.end >= 2 && text_[tag.end - 2] == '/';
    const size_t first = i + (tag.is_end ? 2 : 1);
    size_t last = first;
    while (last < tag.end && !IsSpace(text_[last]) && text_[last] != '/' && text_[last] != '>')
      ++last;
    tag.name = text_.substr(first, last - first);
    tags.push_back(tag);
    i = tag.end;
  }
  return tags;
}

int XmlText::LineOf(size_t place) const {
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(place, text_.size()));
  return 1 + static_cast<int>(std::count(text_.begin(), end, '\n'));
}

std::vector<XmlText::Attributes> XmlText::AttributesOf(const XmlTag& tag) const {
  std::vector<Attributes> attributes;
  size_t i = tag.begin + 1 + tag.name.size();
  while (i < tag.end) {
    const size_t equals = text_.find('=', i);
    if (equals >= tag.end) break;
    size_t name_end = equals;
    while (name_end > i && IsSpace(text_[name_end - 1])) --name_end;
    size_t name_begin = name_end;
    while (name_begin > i && !IsSpace(text_[name_begin - 1])) --name_begin;
    const size_t open = text_.find_first_of("\"'", equals);
    if (open >= tag.end) break;
    const size_t close = text_.find(text_[open], open + 1);
    if (close >= tag.end) break;
    attributes.push_back(
        {text_.substr(name_begin, name_end - name_begin), name_begin, close + 1, open + 1, close});
    i = close + 1;
  }
  return attributes;
}

std::string XmlText::Attribute(const XmlTag& tag, std::string_view name) const {
  for (const Attributes& each : AttributesOf(tag)) {
    if (each.name == name) return text_.substr(each.value_begin, each.value_end - each.value_begin);
  }
  return {};
}

void XmlText::SetAttribute(const XmlTag& tag, std::string_view name, std::string_view value) {
  for (const Attributes& each : AttributesOf(tag)) {
    if (each.name == name)
      text_.replace(each.value_begin, each.value_end - each.value_begin, value);
  }
}

void XmlText::Blank(size_t begin, size_t end) {
  for (size_t i = begin; i < std::min(end, text_.size()); ++i) {
    if (text_[i] != '\n') text_[i] = ' ';
  }
}

bool XmlText::BlankAttribute(const XmlTag& tag, std::string_view name) {
  for (const Attributes& each : AttributesOf(tag)) {
    if (each.name != name) continue;
    Blank(each.begin, each.end);
    return true;
  }
  return false;
}

bool XmlText::BlankValue(const XmlTag& tag, std::string_view value) {
  for (const Attributes& each : AttributesOf(tag)) {
    if (text_.substr(each.value_begin, each.value_end - each.value_begin) != value) continue;
    Blank(each.begin, each.end);
    return true;
  }
  return false;
}

size_t XmlText::EndOfElement(const std::vector<XmlTag>& tags, size_t index) const {
  int depth = 0;
  for (size_t i = index; i < tags.size(); ++i) {
    if (tags[i].name != tags[index].name) continue;
    if (tags[i].is_end) --depth;
    if (!tags[i].is_end && !tags[i].is_empty) ++depth;
    if (depth == 0) return tags[i].end;
  }
  return text_.size();
}

}  // namespace runtime
