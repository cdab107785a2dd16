#include "app/ui/report.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace texelscope::ui {

Id id_of(std::string_view name, Id within) {
    Id hash = 0xCBF29CE484222325U ^ (within * 0x9E3779B97F4A7C15U);
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return hash == 0 ? 1 : hash;
}

std::vector<TextRecord> texts_cut(const FrameReport& report, float slack) {
    std::vector<TextRecord> out;
    std::copy_if(report.texts.begin(), report.texts.end(), std::back_inserter(out),
                 [&](const TextRecord& t) { return !t.scrolls && !t.clip.covers(t.area, slack); });
    return out;
}

float smallest_text(const FrameReport& report, bool subscripts) {
    float least = std::numeric_limits<float>::infinity();
    for (const TextRecord& t : report.texts)
        if (t.subscript == subscripts) least = std::min(least, t.px);
    return least;
}

std::vector<ControlRecord> small_targets(const FrameReport& report, float least) {
    std::vector<ControlRecord> out;
    for (const ControlRecord& c : report.controls) {
        const bool narrow = c.hit.w < std::min(least, c.clip.w) - .01F,
                   low = c.hit.h < std::min(least, c.clip.h) - .01F;
        if (!c.hit.empty() && c.clip.covers(c.hit, .01F) && (narrow || low)) out.push_back(c);
    }
    return out;
}

std::vector<TextRecord> faint_texts(const FrameReport& report, double least) {
    std::vector<TextRecord> out;
    std::copy_if(report.texts.begin(), report.texts.end(), std::back_inserter(out),
                 [&](const TextRecord& t) { return contrast(t.color, t.ground) < least; });
    return out;
}

}  // namespace texelscope::ui
