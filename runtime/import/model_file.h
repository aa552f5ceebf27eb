// A URDF or MJCF file, made ready for MuJoCo.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/import/xml_text.h"

namespace runtime {

// What a file says of a joint and MuJoCo 2.2 does not read.
struct JointLimits {
  double effort = 0;    // 0: not said
  double velocity = 0;  // 0: not said
};

class ModelFile {
 public:
  // Throws UserError where the file cannot be read, or is neither.
  explicit ModelFile(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  bool is_urdf() const { return is_urdf_; }
  const std::string& text() const { return text_.text(); }
  // Meshes by the names that the text has for them now: where they are, or an empty path where they
  // are nowhere to be found or are of a kind that MuJoCo does not read.
  const std::map<std::string, std::filesystem::path>& meshes() const { return meshes_; }
  // Of those without a place: MuJoCo's names.
  const std::set<std::string>& missing() const { return missing_; }
  const std::map<std::string, JointLimits>& limits() const { return limits_; }
  // Whether a URDF file has a link `world`, which MuJoCo takes for the world itself.
  bool has_world() const { return has_world_; }
  // In the order of their lines; what is the same in many places is said once.
  std::vector<std::string> warnings() const;

  // Leaves out what MuJoCo's message is about, with a warning; false where the message names
  // nothing that can be left out.
  bool LeaveOut(const std::string& message);

 private:
  void PutIncludes();
  void SetCompiler();
  void CheckUrdf();
  void TakeVisualShapes();
  void FindLimitsAndWorld();
  void FindForceLimits();
  void FindMeshes();
  void LeaveOutPictures();
  void LeaveOutOwnMujoco();
  std::filesystem::path Find(const std::string& name, const std::string& folder) const;
  std::filesystem::path FindMesh(const std::string& name, const std::string& folder,
                                 const XmlTag& tag);
  std::string PlaceOf(size_t place) const;
  void Warn(size_t place, const std::string& text);
  XmlTag Root() const;

  std::filesystem::path file_;
  XmlText text_;
  bool is_urdf_ = false;
  bool has_includes_ = false;
  bool has_world_ = false;
  std::map<std::string, std::filesystem::path> meshes_;
  std::set<std::string> missing_;
  std::map<std::string, JointLimits> limits_;
  struct Warning {
    int line = 0;  // 0 where the text of other files is in it, and lines have other numbers
    std::string text;
    int count = 1;  // in how many places; the line is the first one's
  };
  std::vector<Warning> warnings_;
};

// In lower case, with its dot.
std::string ExtensionOf(const std::string& name);

}  // namespace runtime
