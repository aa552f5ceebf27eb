#include "runtime/import/urdf_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>

namespace runtime {
namespace {

constexpr double kMostTurns = 2;  // of a joint with stops; more are degrees that are taken for rad
constexpr double kLargest = 20;   // of a shape [m]; more are millimeters
constexpr const char* kTypes = "revolute, continuous, prismatic, fixed, floating or planar";

std::optional<double> FiniteNumber(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  while (end != nullptr && std::isspace(static_cast<unsigned char>(*end)) != 0) ++end;
  const bool is_number = end != text.c_str() && *end == '\0' && std::isfinite(number);
  return is_number ? std::optional(number) : std::nullopt;
}

std::vector<double> NumbersIn(const std::string& text) {
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) numbers.push_back(FiniteNumber(word).value_or(0));
  return numbers;
}

struct UrdfJoint {
  std::string name, type, parent, child;
  size_t place = 0;
  bool has_limit = false;
};

class UrdfChecker {
 public:
  explicit UrdfChecker(const XmlText& text) : text_(text) {}

  std::vector<UrdfProblem> Check() {
    int depth = 0;
    for (const XmlTag& tag : text_.Tags()) {
      if (tag.is_end) {
        if (--depth == 1 && element_ == "joint") EndJoint();
        continue;
      }
      if (depth == 1) Begin(tag);
      if (depth > 1) Look(tag);
      if (!tag.is_empty) ++depth;
    }
    CheckTree();
    std::ranges::stable_sort(problems_, {}, &UrdfProblem::place);
    return std::move(problems_);
  }

 private:
  // A child of the whole file's element.
  void Begin(const XmlTag& tag) {
    if (tag.name.starts_with("xacro:")) {
      Fail(tag,
           fmt::format("`{}` is no URDF: write the file as URDF first, with `xacro`", tag.name));
    }
    element_ = tag.name;
    if (tag.name != "link" && tag.name != "joint") return;
    name_ = text_.Attribute(tag, "name");
    if (name_.empty()) Fail(tag, fmt::format("a {} has no name: add `name`", tag.name));
    auto& known = tag.name == "link" ? links_ : joint_names_;
    const auto [other, is_new] = known.emplace(name_, tag.begin);
    if (!is_new && !name_.empty()) {
      Fail(tag, fmt::format("there is a {} `{}` in line {} already: rename one of them", tag.name,
                            name_, text_.LineOf(other->second)));
    }
    if (tag.name == "joint") {
      joints_.push_back({name_, text_.Attribute(tag, "type"), "", "", tag.begin});
      constexpr std::array<std::string_view, 6> kKnown = {"revolute", "continuous", "prismatic",
                                                          "fixed",    "floating",   "planar"};
      if (std::ranges::find(kKnown, joints_.back().type) == kKnown.end()) {
        Fail(tag, fmt::format("the type of joint `{}` is `{}`: write {}", name_,
                              joints_.back().type, kTypes));
      }
    }
  }

  // What stands in a link or a joint.
  void Look(const XmlTag& tag) {
    if (element_ == "link") LookInLink(tag);
    if (element_ == "joint") LookInJoint(tag);
  }

  void LookInLink(const XmlTag& tag) {
    if (tag.name == "mass") {
      mass_ = Number(tag, "value").value_or(0);
      if (mass_ < 0) {
        Warn(tag, fmt::format("the mass of link `{}` is below 0: it is taken for none; write kg",
                              name_));
      }
    }
    if (tag.name == "inertia") LookAtInertia(tag);
    for (const char* key : {"size", "radius", "length"}) {
      const std::vector<double> sizes = NumbersIn(text_.Attribute(tag, key));
      if (std::ranges::any_of(sizes, [](double size) { return size > kLargest; })) {
        Warn(tag, fmt::format("a shape of link `{}` is {} m large: lengths are in m, not in mm",
                              name_, *std::ranges::max_element(sizes)));
      }
    }
  }

  void LookAtInertia(const XmlTag& tag) {
    bool is_positive = true;
    for (const char* key : {"ixx", "iyy", "izz"}) {
      is_positive = Number(tag, key).value_or(0) > 0 && is_positive;
    }
    for (const char* key : {"ixy", "ixz", "iyz"}) Number(tag, key);
    if (!is_positive && mass_ > 0) {
      Warn(tag, fmt::format("a moment of inertia of link `{}` is not above 0: it gets another one; "
                            "write `ixx`, `iyy` and `izz` in kg m^2",
                            name_));
    }
  }

  void LookInJoint(const XmlTag& tag) {
    UrdfJoint& joint = joints_.back();
    if (tag.name == "parent") joint.parent = text_.Attribute(tag, "link");
    if (tag.name == "child") joint.child = text_.Attribute(tag, "link");
    if (tag.name == "axis") {
      const std::vector<double> axis = NumbersIn(text_.Attribute(tag, "xyz"));
      const bool is_none = std::ranges::all_of(axis, [](double value) { return value == 0; });
      if (is_none && !axis.empty() && joint.type != "fixed") {
        Fail(tag, fmt::format("the axis of joint `{}` has no direction: write for example "
                              "`xyz=\"0 0 1\"`",
                              joint.name));
      }
    }
    if (tag.name == "limit") LookAtLimit(tag, joint);
  }

  void LookAtLimit(const XmlTag& tag, UrdfJoint& joint) {
    joint.has_limit = true;
    Number(tag, "effort");
    Number(tag, "velocity");
    const double low = Number(tag, "lower").value_or(0);
    const double high = Number(tag, "upper").value_or(0);
    if (joint.type != "revolute" && joint.type != "prismatic") return;
    if (low > high) {
      Warn(tag, fmt::format("the lower stop of joint `{}` is above the upper one: it gets none; "
                            "exchange `lower` and `upper`",
                            joint.name));
    }
    const double turns = std::max(std::abs(low), std::abs(high)) / (2 * std::numbers::pi);
    if (joint.type == "revolute" && turns > kMostTurns) {
      Warn(tag, fmt::format("joint `{}` turns from {} to {} rad, which are {:.0f} turns: are these "
                            "degrees? write rad",
                            joint.name, low, high, turns));
    }
  }

  void EndJoint() {
    const UrdfJoint& joint = joints_.back();
    const bool needs_limit = joint.type == "revolute" || joint.type == "prismatic";
    if (needs_limit && !joint.has_limit) {
      problems_.push_back(
          {joint.place, fmt::format("joint `{}` has no `limit`: it is without stops; add "
                                    "`<limit lower=... upper=.../>`, or call it continuous",
                                    joint.name)});
    }
  }

  // Each link hangs on one joint at most, and all on the first.
  void CheckTree() {
    std::map<std::string, const UrdfJoint*> above;
    for (const UrdfJoint& joint : joints_) {
      for (const std::string& link : {joint.parent, joint.child}) {
        if (links_.contains(link)) continue;
        FailAt(joint.place, fmt::format("joint `{}` joins `{}`, and no link is called so: add it, "
                                        "or correct `parent` or `child`",
                                        joint.name, link));
      }
      const auto [other, is_first] = above.emplace(joint.child, &joint);
      if (is_first) continue;
      FailAt(joint.place,
             fmt::format("link `{}` hangs on joint `{}` of line {} already, and links form a tree: "
                         "leave out the joint that closes the loop",
                         joint.child, other->second->name, text_.LineOf(other->second->place)));
    }
    for (const UrdfJoint& joint : joints_) {
      std::set<std::string> passed;
      const UrdfJoint* next = &joint;
      while (next != nullptr && passed.insert(next->child).second) {
        const auto parent = above.find(next->parent);
        next = parent == above.end() ? nullptr : parent->second;
      }
      if (next == nullptr) continue;
      FailAt(joint.place, fmt::format("joint `{}` closes a loop, and links form a tree: leave it "
                                      "out",
                                      joint.name));
      return;
    }
  }

  // Of an attribute that may be missing. One that is no number is a mistake.
  std::optional<double> Number(const XmlTag& tag, const char* key) {
    const std::string written = text_.Attribute(tag, key);
    if (written.empty()) return std::nullopt;
    const std::optional<double> number = FiniteNumber(written);
    if (!number) {
      Fail(tag,
           fmt::format("`{}` of {} `{}` is `{}`: write a number", key, element_, name_, written));
    }
    return number;
  }

  void Warn(const XmlTag& tag, std::string text) {
    problems_.push_back({tag.begin, std::move(text), false});
  }
  void Fail(const XmlTag& tag, std::string text) { FailAt(tag.begin, std::move(text)); }
  void FailAt(size_t place, std::string text) {
    problems_.push_back({place, std::move(text), true});
  }

  const XmlText& text_;
  std::vector<UrdfProblem> problems_;
  std::string element_, name_;  // of the child of the whole file's element that is read
  double mass_ = 0;             // of the link
  std::map<std::string, size_t> links_, joint_names_;  // where they begin
  std::vector<UrdfJoint> joints_;
};

}  // namespace

std::vector<UrdfProblem> ProblemsOfUrdf(const XmlText& text) { return UrdfChecker(text).Check(); }

}  // namespace runtime
