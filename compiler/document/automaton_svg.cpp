// The phases stand below each other, in the order of the text. A way to the next one goes straight
// down; those further down bend to the right, those back to the left, each in a lane of its own
// where they would meet; beside each way stand its conditions.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "compiler/document/automaton.h"

namespace compiler {
namespace {

// All lengths in pixels. The labels are monospaced: so their widths are known.
constexpr double kBoxHeight = 34;
constexpr double kLetter = 8.5;       // of a phase's name
constexpr double kLabelLetter = 7.3;  // of a condition
constexpr double kLabelLine = 17;
constexpr double kGap = 14;     // beside what stands in a lane
constexpr double kMargin = 10;  // around everything
constexpr double kCurve = 16;   // how far a way curves
constexpr size_t kLongestLine = 30;
constexpr size_t kMostLines = 3;  // of a condition; all of it stands in the table of the page

// Broken at its blanks into lines, of which there are not too many.
std::vector<std::string> LinesOf(const std::string& label) {
  std::vector<std::string> lines(1);
  std::istringstream words(label);
  for (std::string word; words >> word;) {
    const bool fits = lines.back().size() + 1 + word.size() <= kLongestLine;
    if (!fits && !lines.back().empty() && lines.size() == kMostLines) {
      lines.back() += " …";
      break;
    }
    if (!fits && !lines.back().empty()) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

// With the lines of its labels in their place.
Automaton::Way WithLines(Automaton::Way way) {
  std::vector<std::string> lines;
  for (const std::string& label : way.labels)
    std::ranges::move(LinesOf((lines.empty() ? "" : "or ") + label), std::back_inserter(lines));
  way.labels = std::move(lines);
  return way;
}

double WidthOf(const Automaton::Way& way) {
  size_t longest = 0;
  for (const std::string& line : way.labels) longest = std::max(longest, line.size());
  return static_cast<double>(longest) * kLabelLetter;
}

double HeightOf(const Automaton::Way& way) {
  return static_cast<double>(way.labels.size()) * kLabelLine;
}

// Ways on one side, sorted into lanes from the inside out.
struct Lane {
  std::vector<const Automaton::Way*> ways;
  double width = 0;  // of its labels
  double x = 0;      // where its ways run
};

size_t First(const Automaton::Way& way) { return std::min(way.from, way.to); }
size_t Last(const Automaton::Way& way) { return std::max(way.from, way.to); }

// Would they cover each other in one lane? Where one begins another may end, but not one that leads
// back to its own phase.
bool Meet(const Automaton::Way& a, const Automaton::Way& b) {
  const bool is_own = a.from == a.to || b.from == b.to;
  if (is_own) return First(a) <= Last(b) && First(b) <= Last(a);
  return First(a) < Last(b) && First(b) < Last(a);
}

std::vector<Lane> LanesOf(std::vector<const Automaton::Way*> ways) {
  std::ranges::stable_sort(ways, {},
                           [](const Automaton::Way* way) { return Last(*way) - First(*way); });
  std::vector<Lane> lanes;
  for (const Automaton::Way* way : ways) {
    const auto is_free = [&](const Lane& lane) {
      return std::ranges::none_of(lane.ways,
                                  [&](const Automaton::Way* other) { return Meet(*way, *other); });
    };
    auto lane = std::ranges::find_if(lanes, is_free);
    if (lane == lanes.end()) lane = lanes.insert(lane, Lane());
    lane->ways.push_back(way);
    lane->width = std::max(lane->width, WidthOf(*way));
  }
  return lanes;
}

class Drawing {
 public:
  explicit Drawing(Automaton automaton) : automaton_(std::move(automaton)) {
    for (Automaton::Way& way : automaton_.ways) way = WithLines(std::move(way));
    for (const Automaton::Way& way : automaton_.ways) {
      if (way.to == way.from + 1) {
        down_.push_back(&way);
      } else {
        (way.to < way.from ? left_ways_ : right_ways_).push_back(&way);
      }
    }
    left_ = LanesOf(left_ways_);
    right_ = LanesOf(right_ways_);
    PlaceRows();
    PlaceColumns();
  }

  std::string Write() {
    for (size_t i = 0; i < automaton_.phases.size(); ++i) Box(i);
    Arrow(fmt::format("M{:.0f} {:.0f}V{:.0f}", center_, kMargin, tops_.front()));
    for (const Automaton::Way* way : down_) Straight(*way);
    for (const Lane& lane : left_)
      for (const Automaton::Way* way : lane.ways) Bent(*way, lane, -1);
    for (const Lane& lane : right_)
      for (const Automaton::Way* way : lane.ways) Bent(*way, lane, 1);
    return fmt::format(
        "<svg class=\"phases\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" "
        "role=\"img\" aria-label=\"the phases and the ways between them\">\n"
        "<defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"8\" "
        "markerHeight=\"8\" markerUnits=\"userSpaceOnUse\" orient=\"auto\">"
        "<path d=\"M0 0L8 4L0 8z\"/></marker></defs>\n{2}</svg>",
        width_, tops_.back() + kBoxHeight + kMargin, content_);
  }

 private:
  // Rows have room for the labels between them, and for what bends back to its own phase.
  void PlaceRows() {
    double y = kMargin + 22;
    for (size_t i = 0; i < automaton_.phases.size(); ++i) {
      double below = 2 * kLabelLine;
      for (const Automaton::Way& way : automaton_.ways) {
        const bool is_beside = First(way) <= i && i < Last(way);
        const auto rows = static_cast<double>(Last(way) - First(way));
        if (is_beside) below = std::max(below, HeightOf(way) / rows + kLabelLine);
        if (way.from == i && way.to == i) below = std::max(below, HeightOf(way));
      }
      tops_.push_back(y);
      y += kBoxHeight + below;
    }
  }

  void PlaceColumns() {
    size_t longest = 0;
    for (const std::string& phase : automaton_.phases) longest = std::max(longest, phase.size());
    box_ = static_cast<double>(longest) * kLetter + 36;
    double room = kMargin;
    for (const Lane& lane : left_) room += lane.width + 2 * kGap;
    center_ = room + box_ / 2;
    double x = center_ - box_ / 2;
    for (Lane& lane : left_) {
      lane.x = x - kGap;
      x = lane.x - kGap - lane.width;
    }
    double labels = 0;
    for (const Automaton::Way* way : down_) labels = std::max(labels, kGap + WidthOf(*way));
    x = center_ + std::max(box_ / 2, labels);
    for (Lane& lane : right_) {
      lane.x = x + kGap;
      x = lane.x + kGap + lane.width;
    }
    width_ = x + kMargin;
  }

  double MiddleOf(size_t phase) const { return tops_[phase] + kBoxHeight / 2; }

  void Box(size_t phase) {
    content_ += fmt::format(
        "<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" rx=\"{:.0f}\"/>"
        "<text class=\"phase\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>\n",
        center_ - box_ / 2, tops_[phase], box_, kBoxHeight, kBoxHeight / 2, center_,
        MiddleOf(phase) + 5, EscapedHtml(automaton_.phases[phase]));
  }

  void Arrow(const std::string& path) {
    content_ += fmt::format("<path class=\"way\" d=\"{}\" marker-end=\"url(#tip)\"/>\n", path);
  }

  void Straight(const Automaton::Way& way) {
    const double from = tops_[way.from] + kBoxHeight;
    const double to = tops_[way.to];
    Arrow(fmt::format("M{:.0f} {:.0f}V{:.0f}", center_, from, to));
    Labels(way, center_ + kGap, (from + to) / 2, "start");
  }

  // `side`: -1 for the left, 1 for the right. It leaves a box below its middle and enters one
  // above.
  void Bent(const Automaton::Way& way, const Lane& lane, int side) {
    const double box = center_ + side * box_ / 2;
    const double down = way.to < way.from ? -1 : 1;
    const bool is_own = way.to == way.from;
    const double from = MiddleOf(way.from) + (is_own ? -7 : down * 7);
    const double to = MiddleOf(way.to) - (is_own ? -7 : down * 7);
    const double curve = is_own ? 7 : kCurve;
    const double bend = lane.x - side * std::min(curve, kGap);
    Arrow(
        fmt::format("M{0:.0f} {1:.0f}H{2:.0f}Q{3:.0f} {1:.0f} {3:.0f} {4:.0f}V{5:.0f}Q{3:.0f} "
                    "{6:.0f} {2:.0f} {6:.0f}H{0:.0f}",
                    box, from, bend, lane.x, from + down * curve, to - down * curve, to));
    Labels(way, lane.x + side * kGap / 2, (from + to) / 2, side < 0 ? "end" : "start");
  }

  void Labels(const Automaton::Way& way, double x, double middle, std::string_view anchor) {
    double y = middle - HeightOf(way) / 2 + kLabelLine - 4;
    for (const std::string& line : way.labels) {
      content_ += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\">{}</text>\n", x,
                              y, anchor, EscapedHtml(line));
      y += kLabelLine;
    }
  }

  Automaton automaton_;
  std::vector<const Automaton::Way*> down_;
  std::vector<const Automaton::Way*> left_ways_;
  std::vector<const Automaton::Way*> right_ways_;
  std::vector<Lane> left_;
  std::vector<Lane> right_;
  std::vector<double> tops_;  // of the boxes
  double box_ = 0;            // their width
  double center_ = 0;
  double width_ = 0;
  std::string content_;
};

}  // namespace

std::string ToSvg(const Automaton& automaton) { return Drawing(automaton).Write(); }

}  // namespace compiler
