#include "app/views/layout.h"

#include <algorithm>
#include <cmath>

namespace texelscope {
namespace {

using ui::Area;

// The reference: 1280 x 720 at 100 %.
constexpr float kWidth = 1280, kHeight = 720;
constexpr float kHeader = 40, kTimeline = 88, kBottom = 96, kCanvasWidth = 656, kCanvasHeight = 496;
constexpr float kPresentingHeader = 56, kCaption = 72, kPresentingTimeline = 96, kTabStrip = 36;
constexpr float kSideWidth = kWidth - kCanvasWidth;
// Below these the side's panels are of no use beside each other, and the bottom row is too low to read.
constexpr float kLeastSide = 416, kLayoutLeastColumn = 210, kLeastLesson = 156;
// Strips may take these shares of the window's height, however large the text.
constexpr float kMostHeader = .14F, kMostTimeline = .25F, kMostCaption = .16F, kMostBottom = .24F;
// Strips grow more slowly than text: a bar of one line has room to spare, a lane is no text.
constexpr float kHeaderGrowth = .8F, kTimelineGrowth = .6F;

// The presenter's text is twice as large to begin with: so much larger its lines still hold what 720 lines show.
constexpr float kMostPresenting = 1;
constexpr float kLeastScale = 1, kLayoutMostScale = 2.5F, kScaleStep = 8;

struct Strips {
    float header, timeline, low;  ///< low: the bottom row's least height, or the caption
};

[[nodiscard]] float strip(float height, float growth, float most) {
    return std::floor(std::min(height * growth, most));
}

[[nodiscard]] Strips strips(glm::vec2 window, const Look& look) {
    const float scale = text_scale(window, look);
    const float ratio = std::sqrt(std::max(1.0F, std::min(window.x / kWidth, window.y / kHeight)));
    const float header = std::max(std::pow(scale, kHeaderGrowth), ratio);
    const float timeline = std::max(std::pow(scale, kTimelineGrowth), ratio);
    if (look.presenting)
        return {strip(kPresentingHeader, scale, window.y * kMostHeader),
                strip(kPresentingTimeline, scale, window.y * kMostTimeline),
                strip(kCaption, scale, window.y * kMostCaption)};
    return {strip(kHeader, header, window.y * kMostHeader), strip(kTimeline, timeline, window.y * kMostTimeline),
            strip(kBottom, scale, window.y * kMostBottom)};
}

/// Wide enough for its share of the window, else as in the reference.
[[nodiscard]] float canvas_width(glm::vec2 window, float height) {
    const float share = std::ceil(kCanvasShare * window.x * window.y / std::max(1.0F, height));
    return std::min(window.x, std::max(share, std::round(window.x * kCanvasWidth / kWidth)));
}

void cut_side(ScreenLayout& at, SideCut cut) {
    const bool face = cut == SideCut::face;
    const float small = std::round(at.side.w * (face ? 248 : 208) / kSideWidth);
    const float top = std::round(at.side.h * (face ? 264 : 208) / kCanvasHeight);
    const Area& s = at.side;
    at.slots = {Area{s.x, s.y, small, top}, Area{s.x + small, s.y, s.w - small, top},
                Area{s.x, s.y + top, s.w, s.h - top}};
}

void cut_tabs(ScreenLayout& at, float strip_height) {
    const Area& s = at.side;
    at.tabbed = true;
    at.tabs = {s.x, s.y, s.w, std::min(std::round(strip_height), s.h)};
    at.tab = {s.x, at.tabs.bottom(), s.w, s.h - at.tabs.h};
}

void place_presenting(ScreenLayout& at, glm::vec2 window, const Strips& strip) {
    const float height = window.y - strip.header - strip.low - strip.timeline;
    const float width = canvas_width(window, height);
    at.canvas = {0, strip.header, width, height};
    at.side = {width, strip.header, window.x - width, height};
    at.caption = {0, at.canvas.bottom(), window.x, strip.low};
    cut_tabs(at, strip.header);
}

void place_tabbed(ScreenLayout& at, glm::vec2 window, const Strips& strip, float scale) {
    const float height = window.y - strip.header - strip.timeline;
    const float width = canvas_width(window, height);
    at.canvas = {0, strip.header, width, height};
    float lesson = std::round(kLeastLesson * scale);
    if (height - lesson < kLayoutLeastColumn * scale) lesson = 0;
    at.side = {width, strip.header, window.x - width, height - lesson};
    at.lesson = lesson > 0 ? Area{width, at.side.bottom(), at.side.w, lesson} : Area{};
    cut_tabs(at, kTabStrip * scale);
}

void place_panels(ScreenLayout& at, glm::vec2 window, const Strips& strip, SideCut cut) {
    const float most = window.y - strip.header - strip.timeline - strip.low;
    const float height = std::min(most, std::round(window.y * kCanvasHeight / kHeight));
    const float width = canvas_width(window, height), bottom = strip.header + height;
    const float low = window.y - strip.timeline - bottom;
    at.canvas = {0, strip.header, width, height};
    at.side = {width, strip.header, window.x - width, height};
    at.variables = {0, bottom, width, low};
    at.lesson = {width, bottom, window.x - width, low};
    cut_side(at, cut);
}

}  // namespace

std::vector<Area> ScreenLayout::panels() const {
    std::vector<Area> all{header, canvas, timeline, variables, lesson, tabs, tab, caption};
    all.insert(all.end(), slots.begin(), slots.end());
    all.erase(std::remove_if(all.begin(), all.end(), [](const Area& a) { return a.empty(); }), all.end());
    return all;
}

float text_scale(glm::vec2 window, const Look& look) {
    const float scale = std::clamp(look.scale, kLeastScale, kLayoutMostScale);
    if (!look.presenting) return scale;
    const float room = std::max(1.0F, std::min(window.x / kWidth, window.y / kHeight));
    return std::clamp(std::floor(std::min(scale, kMostPresenting) * room * kScaleStep) / kScaleStep, kLeastScale,
                      kLayoutMostScale);
}

ScreenLayout layout_screen(glm::vec2 window, const Look& look, SideCut cut) {
    window = {std::max(1.0F, std::floor(window.x)), std::max(1.0F, std::floor(window.y))};
    const float scale = text_scale(window, look);
    const Strips strip = strips(window, look);
    ScreenLayout at;
    at.header = {0, 0, window.x, strip.header};
    at.timeline = {0, window.y - strip.timeline, window.x, strip.timeline};
    if (look.presenting) {
        place_presenting(at, window, strip);
        return at;
    }
    const float height = window.y - strip.header - strip.timeline - strip.low;
    const float side = window.x - canvas_width(window, height);
    if (scale > kTabbedAbove || side < kLeastSide * scale) {
        place_tabbed(at, window, strip, scale);
    } else {
        place_panels(at, window, strip, cut);
    }
    return at;
}

}  // namespace texelscope
