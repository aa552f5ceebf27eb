// A value of a TOML file together with the place where it stands, so that every mistake found in
// it, of form or of meaning, can be reported with file, line and column.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugins/robot/placed_error.h"
#include "plugins/robot/robot_description.h"

namespace robot {

// Throws PlacedError where the text, the contents of `file`, is no TOML.
toml::table ParseToml(std::string_view text, const std::string& file);

class TomlValue {
 public:
  // `file`, as messages name it, and `node` outlive the value. `what` names the value in messages:
  // "link `head`", "`mass` of link `head`".
  TomlValue(const std::string& file, const toml::node& node, std::string what);

  // Each of these throws DescriptionError if the value has another type.
  double Number() const;
  double PositiveNumber() const;
  double NumberNotBelowZero() const;
  bool Flag() const;  // true or false
  int Count() const;  // an integer above 0
  bool IsText() const { return node_->is_string(); }
  bool IsList() const { return node_->is_array(); }
  std::string Text() const;
  // A text that a task can use as a name: letters, digits and underscores, no digit first.
  std::string Name() const;
  // Throws DescriptionError, at this place, if `text` is not such a name.
  void CheckIsName(std::string_view text) const;
  std::vector<TomlValue> Items() const;
  std::vector<double> Numbers(size_t count) const;
  Vector3 ToVector3() const;

  // The entries of a table in the order of the file. Their positions are those of the keys.
  std::vector<std::pair<std::string, TomlValue>> Entries() const;
  std::optional<TomlValue> Find(std::string_view key) const;
  TomlValue At(std::string_view key) const;  // throws DescriptionError if there is none
  // Throws DescriptionError, with the nearest key, if the table has a key that is not among these.
  void AllowKeys(std::span<const std::string_view> keys) const;

  // The index of this text in `names`. Throws DescriptionError with the nearest name, or all of
  // them: "there is no link `haed`". `kind`: "link".
  int IndexIn(const std::vector<std::string>& names, std::string_view kind) const;

  const std::string& what() const { return what_; }
  // The same value under another name in messages.
  TomlValue Called(std::string what) const;
  [[noreturn]] void Fail(std::string_view message, std::string_view help) const;

 private:
  [[noreturn]] void FailType(std::string_view expected) const;
  const toml::table& Table() const;

  const std::string* file_;
  const toml::node* node_;
  toml::source_position position_;
  std::string what_;
};

// "did you mean `x`?", or a list of all names if none is near.
std::string SuggestName(std::string_view name, const std::vector<std::string>& names);

// "`a`, `b` and `c`"
std::string ListNames(const std::vector<std::string>& names);

}  // namespace robot
