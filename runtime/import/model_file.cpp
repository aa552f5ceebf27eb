#include "runtime/import/model_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "base/file/read.h"
#include "runtime/base/user_error.h"
#include "runtime/import/urdf_check.h"

namespace runtime {
namespace {

std::string ReadWhole(const std::filesystem::path& file) {
  file::Reading reading = file::Read(file.string());
  if (!reading.problem.empty()) {
    throw UserError(fmt::format("{}: cannot read the model: {}", file.string(), reading.problem));
  }
  return std::move(reading.bytes);
}

double NumberIn(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

}  // namespace

std::string ExtensionOf(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return extension;
}

ModelFile::ModelFile(const std::filesystem::path& file) : file_(file), text_(ReadWhole(file)) {
  const std::string root = Root().name;
  is_urdf_ = root == "robot";
  if (!is_urdf_ && root != "mujoco") {
    throw UserError(fmt::format(
        "{}: its first element is `{}`, and that of a URDF file is `robot`, that of a MJCF file "
        "`mujoco`{}",
        file.string(), root,
        ExtensionOf(file.string()) == ".xacro" ? "; write it as URDF first, with `xacro`" : ""));
  }
  if (!is_urdf_) PutIncludes();
  if (is_urdf_) {
    CheckUrdf();
    TakeVisualShapes();
    FindLimitsAndWorld();
  } else {
    FindForceLimits();
  }
  FindMeshes();
  if (!is_urdf_) LeaveOutPictures();
  SetCompiler();
}

XmlTag ModelFile::Root() const {
  const std::vector<XmlTag> tags = text_.Tags();
  return tags.empty() ? XmlTag{} : tags.front();
}

// "FILE:LINE"; without the line where the text of other files is in it, and lines have other
// numbers.
std::string ModelFile::PlaceOf(size_t place) const {
  return has_includes_ ? file_.string() : fmt::format("{}:{}", file_.string(), text_.LineOf(place));
}

void ModelFile::Warn(size_t place, const std::string& text) {
  const int line = has_includes_ ? 0 : text_.LineOf(place);
  const auto known = std::ranges::find(warnings_, text, &Warning::text);
  if (known == warnings_.end()) {
    warnings_.push_back({line, text});
  } else {
    known->line = std::min(known->line, line);
    ++known->count;
  }
}

std::vector<std::string> ModelFile::warnings() const {
  std::vector<Warning> sorted = warnings_;
  std::ranges::stable_sort(sorted, {}, &Warning::line);
  std::vector<std::string> texts;
  for (const auto& [line, text, count] : sorted) {
    std::string place = file_.string();
    if (line > 0) place += fmt::format(":{}", line);
    texts.push_back(fmt::format("{}: {}", place, text));
    if (count > 1) texts.back() += fmt::format(" (in {} places)", count);
  }
  return texts;
}

void ModelFile::CheckUrdf() {
  for (const UrdfProblem& problem : ProblemsOfUrdf(text_)) {
    if (problem.is_error) {
      throw UserError(fmt::format("{}: {}", PlaceOf(problem.place), problem.text));
    }
    Warn(problem.place, problem.text);
  }
}

// Each in place of the tag that includes it.
void ModelFile::PutIncludes() {
  constexpr int kMostIncludes = 100;  // more include each other
  for (int i = 0; i <= kMostIncludes; ++i) {
    const std::vector<XmlTag> tags = text_.Tags();
    const auto include = std::ranges::find(tags, "include", &XmlTag::name);
    if (include == tags.end()) return;
    const auto index = static_cast<size_t>(include - tags.begin());
    const std::filesystem::path other = file_.parent_path() / text_.Attribute(*include, "file");
    if (i == kMostIncludes) {
      throw UserError(fmt::format("{}: it includes more than {} files: does one include itself?",
                                  file_.string(), kMostIncludes));
    }
    file::Reading reading = file::Read(other);
    if (!reading.problem.empty()) {
      throw UserError(fmt::format("{}: cannot read {}, which it includes: {}",
                                  PlaceOf(include->begin), other.string(), reading.problem));
    }
    const XmlText inner(std::move(reading.bytes));
    const std::vector<XmlTag> inner_tags = inner.Tags();
    const size_t begin = include->begin;
    text_.Blank(begin, text_.EndOfElement(tags, index));
    has_includes_ = true;
    if (inner_tags.size() < 2) continue;
    const size_t first = inner_tags.front().end;
    text_.Insert(begin, inner.text().substr(first, inner_tags.back().begin - first));
  }
}

void ModelFile::FindLimitsAndWorld() {
  std::string joint;
  for (const XmlTag& tag : text_.Tags()) {
    if (tag.name == "link" && text_.Attribute(tag, "name") == "world") has_world_ = true;
    if (tag.name == "joint") joint = tag.is_end ? "" : text_.Attribute(tag, "name");
    if (tag.name == "limit" && !joint.empty()) {
      limits_[joint] = {NumberIn(text_.Attribute(tag, "effort")),
                        NumberIn(text_.Attribute(tag, "velocity"))};
    }
  }
}

// In a file that has no shapes for collisions: those for the eye.
void ModelFile::TakeVisualShapes() {
  const std::vector<XmlTag> tags = text_.Tags();
  if (std::ranges::find(tags, "collision", &XmlTag::name) != tags.end()) return;
  bool is_any = false;
  for (size_t i = tags.size(); i-- > 0;) {  // what is in front stays where it is
    if (tags[i].name != "visual") continue;
    is_any = true;
    const std::string_view before = tags[i].is_end ? "</visual" : "<visual";
    text_.Blank(tags[i].begin, tags[i].begin + before.size());
    text_.Insert(tags[i].begin, tags[i].is_end ? "</collision" : "<collision");
  }
  if (is_any) {
    Warn(Root().begin, "no link has a shape for collisions: those for the eye are taken for it");
  }
}

// Those of all actuators of a joint together, of which later versions of MuJoCo know.
void ModelFile::FindForceLimits() {
  for (const XmlTag& tag : text_.Tags()) {
    const std::string name = tag.name == "joint" ? text_.Attribute(tag, "name") : "";
    const std::string range = text_.Attribute(tag, "actuatorfrcrange");
    if (name.empty() || range.empty()) continue;
    char* rest = nullptr;
    const double low = std::strtod(range.c_str(), &rest);
    limits_[name].effort = std::max(std::abs(low), std::abs(NumberIn(rest)));
  }
}

std::filesystem::path ModelFile::Find(const std::string& name, const std::string& folder) const {
  std::string rest = name;
  for (const std::string_view scheme : {"package://", "model://", "file://"}) {
    if (rest.starts_with(scheme)) rest = rest.substr(scheme.size());
  }
  // A package's folder is a parent of the file's, whatever it is called here.
  const size_t slash = rest.find('/');
  const std::string in_package = slash == std::string::npos ? rest : rest.substr(slash + 1);
  std::error_code ignored;
  std::filesystem::path from = std::filesystem::absolute(file_, ignored).parent_path();
  for (int up = 0; up < 4; ++up) {
    const std::array places = {from / folder / rest, from / rest, from / in_package};
    for (const std::filesystem::path& place : places) {
      if (std::filesystem::is_regular_file(place, ignored)) return place;
    }
    from = from.parent_path();
  }
  return {};
}

// Gives every mesh a name of its own: MuJoCo knows them by their files' names without folders.
void ModelFile::FindMeshes() {
  const char* const attribute = is_urdf_ ? "filename" : "file";
  std::string folder;
  for (const XmlTag& tag : text_.Tags()) {
    if (tag.name != "compiler") continue;
    for (const char* key : {"assetdir", "meshdir"}) {
      if (const std::string named = text_.Attribute(tag, key); !named.empty()) folder = named;
    }
  }
  bool is_visual = false;
  const std::vector<XmlTag> tags = text_.Tags();
  // From the end: what is found stays where it is when something behind it changes.
  for (auto tag = tags.rbegin(); tag != tags.rend(); ++tag) {
    if (tag->name == "visual") is_visual = tag->is_end;
    const std::string name = tag->name == "mesh" ? text_.Attribute(*tag, attribute) : "";
    if (name.empty() || (is_urdf_ && is_visual)) continue;
    const std::filesystem::path place = FindMesh(name, folder, *tag);
    const std::string known =
        fmt::format("mesh_{}{}", meshes_.size(), place.empty() ? ".stl" : ExtensionOf(name));
    meshes_[known] = place;
    const std::string own = text_.Attribute(*tag, "name");
    const std::string called = is_urdf_      ? std::filesystem::path(known).stem().string()
                               : own.empty() ? std::filesystem::path(name).stem().string()
                                             : own;
    if (place.empty()) missing_.insert(called);
    text_.SetAttribute(*tag, attribute, known);
    // In MJCF a mesh without a name is called as its file.
    constexpr size_t kTag = sizeof("<mesh") - 1;
    if (!is_urdf_ && own.empty())
      text_.Insert(tag->begin + kTag, fmt::format(" name=\"{}\"", called));
  }
}

std::filesystem::path ModelFile::FindMesh(const std::string& name, const std::string& folder,
                                          const XmlTag& tag) {
  std::filesystem::path place = Find(name, folder);
  const std::string extension = ExtensionOf(name);
  if (place.empty()) {
    Warn(tag.begin,
         fmt::format("the mesh {} is not there: its link gets a box in its place", name));
  } else if (extension != ".stl" && extension != ".obj" && extension != ".msh") {
    Warn(tag.begin, fmt::format("the mesh {} is neither STL nor OBJ: its link gets a box in its "
                                "place; convert it, for example with Blender",
                                name));
    place.clear();
  }
  return place;
}

// Textures: what they are on stays, and needs none here.
void ModelFile::LeaveOutPictures() {
  const std::vector<XmlTag> tags = text_.Tags();
  for (size_t i = tags.size(); i-- > 0;) {
    if (tags[i].name != "texture" || tags[i].is_end) continue;
    const std::string name = text_.Attribute(tags[i], "name");
    const std::string type = text_.Attribute(tags[i], "type");
    text_.Blank(tags[i].begin, text_.EndOfElement(tags, i));
    if (name.empty()) continue;
    text_.Insert(tags[i].begin,
                 fmt::format("<texture name=\"{}\" type=\"{}\" builtin=\"flat\" width=\"6\" "
                             "height=\"6\"/>",
                             name, type.empty() ? "cube" : type));
  }
}

// A URDF file may say itself how MuJoCo is to read it; where the meshes are has been taken from it.
void ModelFile::LeaveOutOwnMujoco() {
  const std::vector<XmlTag> tags = text_.Tags();
  for (size_t i = 0; i < tags.size(); ++i) {
    if (tags[i].name == "mujoco" && !tags[i].is_end)
      text_.Blank(tags[i].begin, text_.EndOfElement(tags, i));
  }
}

// How MuJoCo is to read the model: links that cannot move stay links, shapes of a URDF file weigh
// nothing, and what would be refused because it has no mass or inertia gets little, which is then
// seen and told.
void ModelFile::SetCompiler() {
  constexpr const char* kSmall =
      "boundmass=\"1e-9\" boundinertia=\"1e-12\" balanceinertia=\"true\"";
  std::string wanted;
  if (is_urdf_) {
    LeaveOutOwnMujoco();
    wanted = fmt::format(
        "<mujoco><compiler fusestatic=\"false\" discardvisual=\"true\" inertiafromgeom=\"false\" "
        "{}/>"
        "</mujoco>",
        kSmall);
  } else {
    bool says_limits = false;
    for (const XmlTag& tag : text_.Tags()) {
      says_limits =
          says_limits || (tag.name == "compiler" && !text_.Attribute(tag, "autolimits").empty());
    }
    // Later versions take a range for a limit, unless they are told not to.
    wanted = fmt::format("<compiler {}{}/>", kSmall, says_limits ? "" : " autolimits=\"true\"");
    const std::vector<XmlTag> tags = text_.Tags();
    for (size_t i = tags.size(); i-- > 0;) {
      if (tags[i].name == "compiler" && !tags[i].is_end) {
        for (const char* key : {"meshdir", "assetdir", "texturedir", "fusestatic", "boundmass",
                                "boundinertia", "balanceinertia"})
          text_.BlankAttribute(tags[i], key);
      }
    }
  }
  text_.Insert(Root().end, wanted);
}

bool ModelFile::LeaveOut(const std::string& message) {
  static const std::regex kElement("Element '([^']*)', line (\\d+)");
  static const std::regex kAttribute("unrecognized attribute: '([^']*)'");
  static const std::regex kKeyword("invalid keyword: '([^']*)'");
  std::smatch element;
  std::smatch what;
  if (!std::regex_search(message, element, kElement)) return false;
  const bool is_attribute = std::regex_search(message, what, kAttribute);
  const bool is_keyword = !is_attribute && std::regex_search(message, what, kKeyword);
  const bool is_element = message.find("unrecognized element") != std::string::npos;
  const std::vector<XmlTag> tags = text_.Tags();
  for (size_t i = 0; i < tags.size(); ++i) {
    const XmlTag& tag = tags[i];
    if (tag.is_end || tag.name != element[1] || text_.LineOf(tag.begin) != std::stoi(element[2]))
      continue;
    if (is_attribute && text_.BlankAttribute(tag, what[1].str())) {
      Warn(tag.begin, fmt::format("`{}` of `{}` is left out: MuJoCo 2.2 does not know it",
                                  what[1].str(), tag.name));
      return true;
    }
    if (is_keyword && text_.BlankValue(tag, what[1].str())) {
      Warn(tag.begin, fmt::format("`{}` of `{}` is left out: MuJoCo 2.2 does not know it",
                                  what[1].str(), tag.name));
      return true;
    }
    if (is_element) {
      Warn(tag.begin, fmt::format("`{}` is left out: MuJoCo 2.2 does not know it", tag.name));
      text_.Blank(tag.begin, text_.EndOfElement(tags, i));
      return true;
    }
  }
  return false;
}

}  // namespace runtime
