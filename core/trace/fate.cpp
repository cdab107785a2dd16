#include "core/trace/fate.h"

namespace texelscope {

std::string_view text_of(Fate fate) {
    switch (fate) {
        case Fate::written: return "written";
        case Fate::outside_edge_a: return "outside A";
        case Fate::outside_edge_b: return "outside B";
        case Fate::outside_edge_c: return "outside C";
        case Fate::outside_box: return "outside the box";
        case Fate::depth_failed: return "hidden";
        case Fate::zero_area: return "zero area";
        case Fate::culled: return "back face";
        case Fate::off_screen: return "off screen";
        case Fate::not_finite: return "not finite";
        case Fate::behind_eye: return "w is not positive";
        case Fate::undefined: return "undefined";
        case Fate::too_large: return "too many texels";
    }
    return "";
}

std::string_view text_of(Note note) { return note == Note::ghost ? "ghost" : ""; }

}  // namespace texelscope
