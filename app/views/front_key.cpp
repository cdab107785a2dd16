#include "app/views/front_key.h"

#include <array>
#include <map>
#include <string>

#include "app/ui/text.h"
#include "app/views/front_marks.h"

namespace texelscope::front {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kNumbers = "u and v are computed in", kPoints = "A point is", kMethods = "Methods";
constexpr std::string_view kLeads = "filled: on the front of those that draw pixel by pixel",
                           kBeaten = "hollow: beaten, another is faster and no worse",
                           kCrossed = "crossed: samples missing or extra",
                           kSquare = "square: an implementation beside the methods", kDiamond = "diamond: fast, exact",
                           kBar = "bar: up to the bound that it publishes",
                           kDashed = "right of it all is slower than fast";
constexpr std::array<float, 2> kDash{5, 4};
constexpr float kIndent = 22, kFrontKeyLine = 16, kHeading = 21;  ///< [px at 100 %]

class Key {
public:
    Key(ui::Ui& ui, const Area& area) : ui_(ui), area_(area), y_(area.y + ui.px(15)) {}

    void draw(std::span<const FrontPoint> points) {
        heading(kNumbers);
        for (const NumberKey& key : kNumberKeys) mark("method", {.filled = true}, ui_.theme()[key.role], key.title);
        y_ += ui_.px(10);
        heading(kPoints);
        const ui::Color color = ui_.theme()[Role::text];
        mark("method", {.filled = true}, color, kLeads);
        mark("method", {}, color, kBeaten);
        mark("method", {.crossed = true}, color, kCrossed);
        mark("kernel", {}, color, kSquare);
        mark("exact", {}, color, kDiamond);
        bar(color);
        dashed();
        y_ += ui_.px(10);
        heading(kMethods);
        std::map<std::string, std::string> names;
        for (const FrontPoint& p : points)
            if (is_plain(p)) names[letters_of(method_of(p))] = std::string(method_of(p));
        for (const auto& [letters, name] : names) {
            ui_.text(Face::note, {area_.x, y_}, Role::text, letters);
            line(name);
        }
    }

private:
    void heading(std::string_view text) {
        ui_.text_within(Face::title, {area_.x, y_}, area_.w, Role::text, text);
        y_ += ui_.px(kHeading);
    }
    /// Beside a mark, in as many lines as needed.
    void line(std::string_view text) {
        const float indent = ui_.px(kIndent);
        const ui::Font& font = ui_.font(Face::note);
        for (const std::string_view part : ui::wrapped(font, text, area_.w - indent)) {
            ui_.text(Face::note, {area_.x + indent, y_}, Role::muted, part);
            y_ += ui_.px(kFrontKeyLine);
        }
        y_ += ui_.px(3);
    }
    void mark(std::string_view kind, const MarkLook& look, ui::Color color, std::string_view text) {
        draw_mark(ui_, {area_.x + ui_.px(8), y_ - ui_.px(4)}, kind, look, color);
        line(text);
    }
    void bar(ui::Color color) {
        const float x = area_.x + ui_.px(8), top = y_ - ui_.px(11), wide = ui_.px(3);
        ui::line(ui_.list(), {x, top}, {x, y_ + ui_.px(2)}, ui_.px(1.2F), color);
        ui::line(ui_.list(), {x - wide, top}, {x + wide, top}, ui_.px(1.6F), color);
        line(kBar);
    }
    void dashed() {
        const float x = area_.x + ui_.px(8);
        const std::array<glm::vec2, 2> path{glm::vec2(x, y_ + ui_.px(3)), glm::vec2(x, y_ - ui_.px(12))};
        ui::draw_dashed(ui_.list(), path, kDash, ui_.px(1.5F), ui_.theme()[Role::now]);
        line(kDashed);
    }

    ui::Ui& ui_;
    Area area_;
    float y_;
};

}  // namespace

void draw_key(ui::Ui& ui, const Area& area, std::span<const FrontPoint> points) { Key(ui, area).draw(points); }

}  // namespace texelscope::front
