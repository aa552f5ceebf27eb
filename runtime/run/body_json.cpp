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

robot::ShapeKind ShapeKindOf(const std::string& name) {
  for (const auto kind : {robot::ShapeKind::kBox, robot::ShapeKind::kCapsule}) {
    if (name == ShapeName(kind)) return kind;
  }
  return robot::ShapeKind::kSphere;
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

std::vector<robot::Link> ParseBody(const std::string& json) {
  std::vector<robot::Link> links;
  try {
    for (const nlohmann::json& link : nlohmann::json::parse(json)) {
      robot::Link& parsed = links.emplace_back();
      parsed.name = link.at("name");
      parsed.shape.kind = ShapeKindOf(link.at("shape"));
      parsed.shape.size = link.at("size");
      parsed.shape.radius = link.at("radius");
      parsed.shape.length = link.at("length");
      parsed.shape.axis = link.at("axis");
    }
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return links;
}

}  // namespace runtime
