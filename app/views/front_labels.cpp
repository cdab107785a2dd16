#include "app/views/front_labels.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/ui/text.h"
#include "app/views/canvas_labels.h"
#include "app/views/front_marks.h"
#include "app/views/front_plot.h"

namespace texelscope::front {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr float kScan = 6;          ///< between two places that are tried [px at 100 %]
constexpr glm::vec2 kReach{13, 7};  ///< points that share a label [px at 100 %]
constexpr float kWidest = 128;      ///< a shared label's line [px at 100 %]
constexpr float kFewLines = 16;     ///< a plot less high names only what leads: too large letters, or too small a plot
constexpr float kPlate = .72F;      ///< how much of the ground hides what is under letters

struct Word {
    std::string text;
    Role role = Role::text;
    glm::vec2 at{0};  ///< its top left in the label
};
struct Label {
    std::vector<const FrontPoint*> points;
    std::vector<Word> words;
    Face face = Face::note;
    glm::vec2 size{0};
    int rank = 0;  ///< lower ones choose their places first
    Area marks, place;
};

class Labels {
public:
    Labels(ui::Ui& ui, const Axes& axes) : ui_(ui), axes_(axes), places_(axes.plot().inset(3, 3)) {}

    void draw(std::span<const FrontPoint* const> points, std::span<const Area> lines) {
        for (const FrontPoint* p : points) places_.block(mark_of(*p));
        for (const Area& line : lines) places_.block(line);
        std::vector<Label> labels = all_labels(points);
        std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.rank < b.rank; });
        ui_.set_ground(ui_.theme().canvas);
        for (Label& label : labels) find_place(label);
        for (const Label& label : labels) draw_leader(label);
        for (const Label& label : labels) draw_words(label);
    }

private:
    [[nodiscard]] Area mark_of(const FrontPoint& p) const {
        const glm::vec2 at = axes_.place_of(p);
        const float r = radius_of(ui_, p.kind) + 1;
        return {at.x - r, at.y - r, 2 * r, 2 * r};
    }

    [[nodiscard]] std::vector<Label> all_labels(std::span<const FrontPoint* const> points) const {
        std::vector<Label> labels;
        std::vector<const FrontPoint*> others;
        for (const FrontPoint* p : points) {
            if (is_large(*p) || leads(*p))
                labels.push_back(label_of({p}, is_large(*p) ? 0 : 1));
            else
                others.push_back(p);
        }
        if (axes_.plot().h < kFewLines * line_of(ui_.font(Face::note))) return labels;
        std::vector<glm::vec2> places;
        std::transform(others.begin(), others.end(), std::back_inserter(places),
                       [&](const FrontPoint* p) { return axes_.place_of(*p); });
        const std::vector<int> sets = grouped_places(places, kReach * ui_.fonts().spec().scale);
        const int count = sets.empty() ? 0 : *std::max_element(sets.begin(), sets.end()) + 1;
        for (int set = 0; set < count; ++set) {
            std::vector<const FrontPoint*> members;
            for (std::size_t n = 0; n < others.size(); ++n)
                if (sets[n] == set) members.push_back(others[n]);
            const bool plain = std::all_of(members.begin(), members.end(), [](const auto* p) { return is_plain(*p); });
            labels.push_back(label_of(std::move(members), plain ? 3 : 2));
        }
        return labels;
    }

    /// One after the other, the fastest first, in lines of about kWidest.
    [[nodiscard]] Label label_of(std::vector<const FrontPoint*> points, int rank) const {
        std::stable_sort(points.begin(), points.end(),
                         [](const FrontPoint* a, const FrontPoint* b) { return a->min_ns < b->min_ns; });
        Label label{.points = std::move(points), .face = rank < 2 ? Face::title : Face::note, .rank = rank};
        const ui::Font& font = ui_.font(label.face);
        const float line = line_of(font), space = ui_.px(6);
        glm::vec2 pen{0};
        for (const FrontPoint* p : label.points) {
            Word word{rank < 2 ? p->label : front_mark(*p), rank < 2 ? Role::text : role_of(*p)};
            const float width = ui::text_width(font, word.text);
            if (pen.x > 0 && pen.x + width > ui_.px(kWidest)) pen = {0, pen.y + line};
            word.at = pen;
            pen.x += width + space;
            label.size.x = std::max(label.size.x, pen.x - space);
            label.words.push_back(std::move(word));
        }
        label.size = {std::ceil(label.size.x) + 4, pen.y + line};
        return label;
    }

    void find_place(Label& label) {
        Area marks = mark_of(*label.points.front());
        for (const FrontPoint* p : label.points) {
            const Area mark = mark_of(*p);
            const float x = std::min(marks.x, mark.x), y = std::min(marks.y, mark.y);
            marks = {x, y, std::max(marks.right(), mark.right()) - x, std::max(marks.bottom(), mark.bottom()) - y};
        }
        label.marks = marks;
        // What leads stands left of its point, where nothing that it beats can be; sets above them; the rest right.
        const bool many = label.points.size() > 1;
        const glm::vec2 away = label.rank < 2 ? glm::vec2(-1, 0) : many ? glm::vec2(0, -1) : glm::vec2(1, 0);
        const float gap = std::min(marks.w, marks.h) / 2 + ui_.px(2);
        if (const auto place = places_.place(marks.centre(), label.size, away, gap)) return void(label.place = *place);
        label.place = nearest_free(marks, label.size);
        places_.block(label.place);
    }
    /// Of the whole plot; empty where it is full.
    [[nodiscard]] Area nearest_free(const Area& marks, glm::vec2 size) const {
        const Area& plot = axes_.plot();
        Area best;
        float least = plot.w + plot.h;
        for (float y = plot.y; y + size.y < plot.bottom(); y += ui_.px(kScan))
            for (float x = plot.x; x + size.x < plot.right(); x += ui_.px(kScan)) {
                const Area here{std::round(x), std::round(y), size.x, size.y};
                const float far = glm::distance(nearest(marks, here.centre()), nearest(here, marks.centre()));
                if (far < least && places_.is_free(here)) least = far, best = here;
            }
        return best;
    }
    [[nodiscard]] static glm::vec2 nearest(const Area& area, glm::vec2 to) {
        return {std::clamp(to.x, area.x, area.right()), std::clamp(to.y, area.y, area.bottom())};
    }
    void draw_leader(const Label& label) const {
        if (label.place.empty()) return;
        const glm::vec2 from = nearest(label.marks, label.place.centre()), to = nearest(label.place, from);
        if (glm::distance(from, to) > ui_.px(6))
            ui::line(ui_.list(), from, to, 1, ui::with_alpha(ui_.theme()[label.words.front().role], .6F));
    }
    void draw_words(const Label& label) {
        if (label.place.empty()) return;
        ui::fill(ui_.list(), label.place, ui::with_alpha(ui_.theme().canvas, kPlate));
        const ui::Font& font = ui_.font(label.face);
        for (const Word& word : label.words) {
            const glm::vec2 at{label.place.x + 2 + word.at.x, label.place.y + word.at.y + line_of(font) / 2};
            ui_.text(label.face, {at.x, ui::baseline_at_middle(font, at.y)}, word.role, word.text);
        }
    }
    [[nodiscard]] static float line_of(const ui::Font& font) { return std::ceil(font.em * 1.18F); }

    ui::Ui& ui_;
    const Axes& axes_;
    canvas::LabelPlaces places_;
};

}  // namespace

std::vector<int> grouped_places(std::span<const glm::vec2> places, glm::vec2 reach) {
    std::vector<int> sets(places.size(), -1);
    int count = 0;
    for (std::size_t first = 0; first < places.size(); ++first) {
        if (sets[first] >= 0) continue;
        std::vector<std::size_t> open{first};
        sets[first] = count;
        while (!open.empty()) {
            const glm::vec2 here = places[open.back()];
            open.pop_back();
            for (std::size_t n = 0; n < places.size(); ++n) {
                const glm::vec2 far = glm::abs(places[n] - here);
                if (sets[n] >= 0 || far.x > reach.x || far.y > reach.y) continue;
                sets[n] = count;
                open.push_back(n);
            }
        }
        ++count;
    }
    return sets;
}

void draw_labels(ui::Ui& ui, const Axes& axes, std::span<const FrontPoint* const> points, std::span<const Area> lines) {
    Labels(ui, axes).draw(points, lines);
}

}  // namespace texelscope::front
