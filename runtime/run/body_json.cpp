#include "runtime/run/body_json.h"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace runtime {
namespace {

const char* ShapeName(robot::ShapeKind kind) {
  switch (kind) {
    case robot::ShapeKind::kBox:
      return "box";
    case robot::ShapeKind::kCapsule:
      return "capsule";
    case robot::ShapeKind::kSphere:
      return "sphere";
  }
  std::abort();
}

}  // namespace

std::string BodyJson(const robot::RobotDescription& robot) {
  nlohmann::ordered_json links = nlohmann::ordered_json::array();
  for (const robot::Link& link : robot.links) {
    links.push_back({{"name", link.name},
                     {"shape", ShapeName(link.shape.kind)},
                     {"size", link.shape.size},
                     {"radius", link.shape.radius},
                     {"length", link.shape.length},
                     {"axis", link.shape.axis}});
  }
  return links.dump();
}

}  // namespace runtime
