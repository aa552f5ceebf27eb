// XML as a text whose tags can be found and changed in place, so that every line keeps its number.
// Not a validating parser: what is not well-formed MuJoCo's own parser refuses.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace runtime {

// A tag of an XML text, by its place in it.
struct XmlTag {
  size_t begin = 0;  // of `<`
  size_t end = 0;    // behind `>`
  std::string name;
  bool is_end = false;    // </name>
  bool is_empty = false;  // <name/>
};

class XmlText {
 public:
  explicit XmlText(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }
  // All of them in their order, without comments, declarations and CDATA.
  std::vector<XmlTag> Tags() const;
  int LineOf(size_t place) const;  // from 1

  // Empty where the tag has no such attribute.
  std::string Attribute(const XmlTag& tag, std::string_view name) const;
  // Replaces the attribute's value. Makes tags found before invalid.
  void SetAttribute(const XmlTag& tag, std::string_view name, std::string_view value);
  void Insert(size_t place, std::string_view text) { text_.insert(place, text); }
  // Leaves spaces, and the ends of lines.
  void Blank(size_t begin, size_t end);
  // The same for one attribute; false where there is none. The tags stay valid.
  bool BlankAttribute(const XmlTag& tag, std::string_view name);
  // The same for the attribute with this value.
  bool BlankValue(const XmlTag& tag, std::string_view value);
  // From `<` to behind the end of the whole element, whose start tag is tags[index].
  size_t EndOfElement(const std::vector<XmlTag>& tags, size_t index) const;

 private:
  struct Attributes {
    std::string name;
    size_t begin, end;              // of all of it
    size_t value_begin, value_end;  // between the quotes
  };
  std::vector<Attributes> AttributesOf(const XmlTag& tag) const;

  std::string text_;
};

}  // namespace runtime
