#include "runtime/import/site_parts.h"

#include "runtime/import/body_parts.h"

namespace runtime {

SitePart FrameOf(const mjModel& model, const mjData& data, int body) {
  const mjtNum* q = data.xquat + 4 * body;
  return {NameIn(model, mjOBJ_BODY, body), Eigen::Vector3d(data.xpos + 3 * body),
          Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
}

std::vector<SitePart> SitesOf(const mjModel& model, const mjData& data, int body) {
  std::vector<SitePart> sites;
  for (int site = 0; site < model.nsite; ++site) {
    if (model.site_bodyid[site] != body) continue;
    mjtNum q[4];
    mju_mat2Quat(q, data.site_xmat + 9 * site);
    sites.push_back({NameIn(model, mjOBJ_SITE, site), Eigen::Vector3d(data.site_xpos + 3 * site),
                     Eigen::Quaterniond(q[0], q[1], q[2], q[3])});
  }
  return sites;
}

}  // namespace runtime
