// The lesson's current beat, and its prediction beside or below it. A scene without a lesson gets hints.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/state/lesson_cursor.h"
#include "app/ui/text.h"
#include "app/ui/widgets.h"
#include "app/views/screen_parts.h"

namespace texelscope {
namespace {

using ui::Area;
using ui::Face;
using ui::Role;

constexpr std::string_view kLessonPanelLesson = "Lesson", kScene = "Scene", kPredict = "Predict", kCheck = "Check",
                           kSkip = "Skip";
constexpr std::string_view kCheckTip = "Compare with what the engine computes (P)",
                           kSkipTip = "Go on without an answer";
constexpr std::string_view kLessonPanelPrevious = "The beat before (PgUp)", kLessonPanelNext = "The next beat (PgDn)";
constexpr std::string_view kSkipped = "Skipped.", kRight = "Right.", kLessonPanelWrong = "Not so.", kSee = "See {}";
constexpr std::string_view kSeeShort = "See why", kSeeTip = "Go to {}, the first step that explains it";
constexpr std::string_view kPickPixel = "Click a pixel on the canvas.", kPickTexel = "Click a texel.",
                           kPickLine = "Click a line of the code.";
constexpr std::string_view kTakePinned = "Take {}", kTakeTip = "Answer with what is pinned",
                           kRemoveTip = "Take this out of the answer";
constexpr std::string_view kNumberHint = "a number";
constexpr std::string_view kStepHint =
                               "`→` steps on, `↓` steps finer, and the formula, the code and the texels follow.",
                           kCornerHint = "Drag a corner, or hold `V` with the arrows. Click a pixel to pin it.",
                           kSolidHint = "Drag with the right button to turn a solid, or hold `O` with the arrows.",
                           kKeysHint = "`L` lists the lessons, `F1` the keys.";

struct Place {
    float row, gap;  ///< a button's height; between rows
};
[[nodiscard]] Place metrics(const ui::Ui& ui) {
    return {std::max(ui.px(ui::size::kAnswerButton), std::round(ui.font(Face::title).em * 1.6F)), ui.px(6)};
}

[[nodiscard]] const Answer* answer_of(const State& state) {
    for (const Answer& answer : state.work.answers) {
        if (answer.beat == state.cursor.beat) return &answer;
    }
    return nullptr;
}

/// "row 11, pixel 16": the two finest parts of a path.
[[nodiscard]] std::string words_of(const Path& path) {
    std::vector<std::string> words;
    for (const PathPart& part : path.parts) {
        switch (part.letter) {
            case 't': words.push_back(fmt::format("shape {}", part.index + 1)); break;
            case 's': words.push_back(fmt::format("stage {}", part.index + 1)); break;
            case 'y': words.push_back(fmt::format("row {}", part.index)); break;
            case 'x': words.push_back(fmt::format("pixel {}", part.index)); break;
            case 'e': break;
            default: words.push_back(fmt::format("{} {}", part.letter, part.index));
        }
    }
    if (words.empty()) return "the step";
    return words.size() == 1 ? words.back() : words[words.size() - 2] + ", " + words.back();
}

/// Places controls in rows from left to right.
class Flow {
public:
    Flow(const Area& area, const Place& place) : area_(area), place_(place), x_(area.x), y_(area.y) {}
    [[nodiscard]] Area next(float width) {
        width = std::min(std::ceil(width), area_.w);
        if (x_ > area_.x && x_ + width > area_.right()) x_ = area_.x, y_ += place_.row + place_.gap;
        const Area at{std::round(x_), y_, width, place_.row};
        x_ += width + gap();
        return at;
    }
    /// Between two controls in a row.
    [[nodiscard]] float gap() const { return place_.gap - 1; }
    [[nodiscard]] bool fits(float width) const { return x_ + width <= area_.right(); }
    /// Moves on so that `width` ends at the right border, where it still fits into the row.
    void push_right(float width) {
        if (x_ + width <= area_.right()) x_ = area_.right() - width;
    }
    [[nodiscard]] float bottom() const { return y_ + place_.row; }

private:
    Area area_;
    Place place_;
    float x_, y_;
};

[[nodiscard]] Selection::Kind kind_asked(Prediction::Kind kind) {
    switch (kind) {
        case Prediction::Kind::pixel: return Selection::Kind::pixel;
        case Prediction::Kind::texel: return Selection::Kind::texel;
        case Prediction::Kind::line: return Selection::Kind::line;
        default: return Selection::Kind::none;
    }
}

class QuestionDrawer {
public:
    QuestionDrawer(const ViewContext& c, const Prediction& asked, const Area& area)
        : c_(c), asked_(asked), answer_(answer_of(c.state)), area_(area), place_(metrics(c.ui)) {}

    /// Once checked the verdict stands where the question stood, and the way to its reason where Check did.
    /// @return its height.
    float draw() {
        const bool open = answer_ == nullptr || answer_->verdict == Answer::Verdict::open;
        const float y = area_.y + (open ? draw_ask() : draw_verdict()) + place_.gap;
        Flow flow({area_.x, y, area_.w, area_.h}, place_);
        draw_answers(flow);
        if (open) return draw_check(flow) - area_.y;
        draw_reason(flow);
        return flow.bottom() - area_.y;
    }

private:
    [[nodiscard]] ui::Ui& ui() const { return c_.ui; }
    float draw_ask() const {
        std::vector<ui::Span> spans{{ui::Span::Kind::strong, std::string(kPredict) + "\u00A0 ", Role::now}};
        const std::vector<ui::Span> ask = ui::spans_of(asked_.ask);
        spans.insert(spans.end(), ask.begin(), ask.end());
        return ui().prose("prediction/ask", area_, spans);
    }
    void draw_answers(Flow& flow) const {
        if (asked_.kind == Prediction::Kind::number) return draw_number(flow);
        if (kind_asked(asked_.kind) != Selection::Kind::none) return draw_places(flow);
        for (std::size_t n = 0; n < asked_.options.size(); ++n) {
            ui::ButtonStyle style;
            style.chosen = answer_ != nullptr &&
                           std::count(answer_->chosen.begin(), answer_->chosen.end(), static_cast<int>(n)) > 0;
            style.kind = ui::Kind::choice;
            const std::string& label = asked_.options[n];
            const float least = place_.row * 1.3F, width = std::max(least, ui::button_width(ui(), label));
            if (ui::button(ui(), fmt::format("prediction/option/{}", n), flow.next(width), label, {}, style).clicked)
                c_.act(action::Choose{static_cast<int>(n)});
        }
    }
    void draw_number(Flow& flow) const {
        const ui::FieldResult field = ui::field(ui(), "prediction/number", flow.next(ui().px(120)),
                                                answer_ != nullptr ? answer_->typed : "", kNumberHint);
        if (field.committed) c_.act(action::Type{field.text});
    }
    [[nodiscard]] std::string text_of_place(glm::ivec2 at) const {
        if (asked_.kind == Prediction::Kind::line) return fmt::format("line {}", at.x);
        return fmt::format("{}, {}", at.x, at.y);
    }
    void draw_places(Flow& flow) const {
        const std::string_view hint = asked_.kind == Prediction::Kind::pixel   ? kPickPixel
                                      : asked_.kind == Prediction::Kind::texel ? kPickTexel
                                                                               : kPickLine;
        const bool empty = answer_ == nullptr || answer_->places.empty();
        if (empty) {
            const Area at = flow.next(ui::text_width(ui().font(Face::prose), hint) + ui().px(8));
            ui().text_within(Face::prose, {at.x, ui::baseline_at_middle(ui().font(Face::prose), at.centre().y)}, at.w,
                             Role::muted, hint);
        }
        ui::ButtonStyle style;
        style.face = Face::code_note;
        for (std::size_t n = 0; !empty && n < answer_->places.size(); ++n) {
            style.chosen = true;
            const std::string label = text_of_place(answer_->places[n]);
            const Area at = flow.next(ui::button_width(ui(), label, style.face));
            if (ui::button(ui(), fmt::format("prediction/place/{}", n), at, label, kRemoveTip, style).clicked)
                c_.act(action::Point{answer_->places[n]});
        }
        const Selection& pinned = c_.state.pinned;
        if (pinned.kind != kind_asked(asked_.kind)) return;
        const glm::ivec2 at = pinned.kind == Selection::Kind::line ? glm::ivec2{pinned.line, 0} : pinned.at;
        if (!empty && std::count(answer_->places.begin(), answer_->places.end(), at) > 0) return;
        style.chosen = false;
        const std::string label = fmt::format(kTakePinned, text_of_place(at));
        if (ui::button(ui(), "prediction/pinned", flow.next(ui::button_width(ui(), label, style.face)), label, kTakeTip,
                       style)
                .clicked)
            c_.act(action::Point{at});
    }
    /// Check at the right, where the verdict's reason will stand, and Skip before it where there is room, else below.
    /// @return the bottom.
    float draw_check(Flow& flow) const {
        const float check = std::ceil(ui::button_width(ui(), kCheck)), skip = std::ceil(ui::button_width(ui(), kSkip));
        const bool beside = flow.fits(skip + flow.gap() + check);
        flow.push_right(beside ? skip + flow.gap() + check : check);
        if (beside) draw_skip(flow.next(skip));
        if (ui::button(ui(), "prediction/check", flow.next(check), kCheck, kCheckTip).clicked) c_.act(action::Check{});
        if (beside) return flow.bottom();
        const float height = std::max(ui().px(24), ui().font(Face::title).em * 1.4F);
        const Area below{area_.right() - skip, flow.bottom() + ui().px(2), skip, height};
        draw_skip(below);
        return below.bottom();
    }
    void draw_skip(const Area& at) const {
        ui::ButtonStyle quiet;
        quiet.quiet = true;
        if (ui::button(ui(), "prediction/skip", at, kSkip, kSkipTip, quiet).clicked) c_.act(action::Skip{});
    }
    /// A sign and the sentence. @return the height.
    float draw_verdict() const {
        const Answer::Verdict verdict = answer_->verdict;
        const ui::Font& font = ui().font(Face::prose);
        const float line = font.em * 1.55F, side = std::round(font.em);
        const Area sign{area_.x, std::round(area_.y + (line - side) / 2), side, side};
        const ui::Theme& theme = ui().theme();
        if (verdict == Answer::Verdict::right) ui::draw_icon(ui().list(), ui::Icon::tick, sign, theme[Role::now]);
        if (verdict == Answer::Verdict::wrong) ui::cross(ui().list(), sign.centre(), side * .3F, 2, theme[Role::error]);
        const bool right = verdict == Answer::Verdict::right, wrong = verdict == Answer::Verdict::wrong;
        const std::string_view word = right ? kRight : wrong ? kLessonPanelWrong : kSkipped;
        std::vector<ui::Span> spans{{ui::Span::Kind::strong, std::string(word) + "\u00A0 "}};
        const std::vector<ui::Span> sentence = ui::spans_of(answer_->sentence);
        spans.insert(spans.end(), sentence.begin(), sentence.end());
        const float left = right || wrong ? sign.right() + ui().px(6) : area_.x;
        return ui().prose("prediction/verdict", {left, area_.y, area_.right() - left, area_.h}, spans);
    }
    void draw_reason(Flow& flow) const {
        if (answer_->verdict == Answer::Verdict::right || answer_->explain.empty()) return;
        const std::string step = words_of(answer_->explain);
        std::string label = fmt::format(kSee, step);
        if (!flow.fits(ui::button_width(ui(), label))) label = kSeeShort;
        const float width = ui::button_width(ui(), label);
        flow.push_right(width);
        if (ui::button(ui(), "prediction/see", flow.next(width), label, fmt::format(kSeeTip, step)).clicked)
            c_.act(action::StepTo{answer_->explain});
    }

    const ViewContext& c_;
    const Prediction& asked_;
    const Answer* answer_;
    Area area_;
    Place place_;
};

float draw_prose(ui::Ui& ui, std::string_view name, const Area& area, const Beat& beat) {
    float y = area.y;
    std::vector<ui::Span> lead = ui::spans_of(beat.lead);
    for (ui::Span& span : lead) {
        if (span.kind == ui::Span::Kind::text) span.kind = ui::Span::Kind::strong;
    }
    if (!beat.lead.empty()) y += ui.prose(fmt::format("{}/lead", name), {area.x, y, area.w, area.h}, lead);
    std::string_view rest = beat.prose;
    for (int n = 0; !rest.empty(); ++n) {
        const std::size_t end = rest.find("\n\n");
        const std::string_view paragraph = rest.substr(0, end);
        y += ui.prose(fmt::format("{}/{}", name, n), {area.x, y, area.w, area.h}, ui::spans_of(paragraph));
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 2);
        if (!rest.empty()) y += ui.px(6);
    }
    return y - area.y;
}

/// A stroke for each beat, then "3 of 7" and the buttons to the next and the one before.
void draw_progress(const ViewContext& c, const Area& row, float x) {
    ui::Ui& ui = c.ui;
    const int count = beat_count(c.state), beat = c.state.cursor.beat;
    const std::string text = fmt::format("{} of {}", beat + 1, count);
    const float label = ui::text_width(ui.font(Face::note), text) + ui.px(8),
                side = std::min(row.h, std::max(ui.px(24), ui.font(Face::note).em * 1.4F));
    const float room = row.right() - x - label - 2 * side - ui.px(4);
    const float pitch = std::min(ui.px(12), std::floor(room / static_cast<float>(count)));
    const float width = std::max(2.0F, std::round(pitch * .67F)), height = ui.px(4),
                middle = std::round(row.centre().y);
    for (int n = 0; pitch >= 3 && n < count; ++n) {
        const Role role = n == beat ? Role::now : n < beat ? Role::covered : Role::rejected;
        ui::fill(ui.list(), {x, middle - height / 2, width, height}, ui.theme()[role], height / 2);
        x += pitch;
    }
    x += ui.px(4);
    x += ui.text_within(Face::note, {x, ui::baseline_at_middle(ui.font(Face::note), middle)}, row.right() - x,
                        Role::muted, text) +
         ui.px(4);
    if (x + 2 * side > row.right() + 1) return;
    const auto turn = [&](std::string_view name, int by, std::string_view tip, bool enabled) {
        const Area at{x, std::round(middle - side / 2), side, side};
        ui::ButtonStyle style;
        style.quiet = true, style.enabled = enabled;
        if (ui::button(ui, name, at, " ", tip, style).clicked) c.act(action::Advance{by});
        const float r = side * .18F, way = static_cast<float>(by);
        const glm::vec2 m = at.centre();
        const ui::Color color = ui.theme()[enabled ? Role::text : Role::faint];
        ui::line(ui.list(), {m.x - way * r / 2, m.y - r}, {m.x + way * r / 2, m.y}, 1.4F, color);
        ui::line(ui.list(), {m.x + way * r / 2, m.y}, {m.x - way * r / 2, m.y + r}, 1.4F, color);
        x += side;
    };
    turn("beat/previous", -1, kLessonPanelPrevious, beat > 0);
    turn("beat/next", 1, kLessonPanelNext, beat + 1 < count);
}

void draw_hints(const ViewContext& c, const Area& place) {
    ui::Ui& ui = c.ui;
    const Area content = ui.begin_panel("lesson", place, kScene, c.state.document->id);
    const Area area = ui.begin_scroll("lesson/prose", content);
    float y = area.y;
    for (const std::string& warning : c.state.document->warnings) {
        y += ui.prose("lesson/warning", {area.x, y, area.w, area.h}, ui::spans_of(warning, Role::error));
    }
    const bool solids = !c.state.document->scene.meshes.empty();
    for (const std::string_view hint : {kStepHint, solids ? kSolidHint : kCornerHint, kKeysHint})
        y += ui.prose("lesson/hint", {area.x, y, area.w, area.h}, ui::spans_of(hint));
    ui.end_scroll(y - area.y);
    ui.end_panel();
}

}  // namespace

void draw_lesson_panel(const ViewContext& c, const Area& place) {
    if (place.empty() || !c.state.document) return;
    if (!c.state.document->lesson || beat_count(c.state) == 0) return draw_hints(c, place);
    ui::Ui& ui = c.ui;
    const Beat& beat = c.state.document->lesson->beats[static_cast<std::size_t>(c.state.cursor.beat)];
    const bool asks = beat.prediction.has_value();
    constexpr float kLeastBeside = 420, kProse = .413F, kQuestion = .458F;
    const float scale = ui.fonts().spec().scale, pad = ui.px(ui::size::kPadding);
    const bool beside = asks && !ui.presenting() && place.w >= kLeastBeside * scale;
    const float left = beside ? std::round(kProse * place.w) : place.w;

    static_cast<void>(ui.begin_panel("lesson", place));
    const float head = std::max(ui.px(ui::size::kContentTop), std::round(ui.font(Face::note).em * 1.6F));
    const Area row{place.x + pad, place.y + 1, left - pad - ui.px(4), head};
    const float baseline = ui.presenting() ? ui::baseline_at_middle(ui.font(Face::title), row.centre().y)
                                           : place.y + ui.px(ui::size::kTitleBaseline);
    const float title = ui.text(Face::title, {row.x, baseline}, Role::muted, kLessonPanelLesson);
    draw_progress(c, {row.x, baseline - ui.font(Face::title).cap / 2 - head / 2, row.w, head},
                  std::round(row.x + title + ui.px(12)));

    const Area prose_place{place.x + pad, place.y + head, left - pad - (beside ? ui.px(4) : pad), place.h - head - 2};
    const Area prose = ui.begin_scroll("lesson/prose", prose_place);
    float height = draw_prose(ui, "lesson/prose", prose, beat);
    if (asks && !beside) {
        const float y = prose.y + height + ui.px(8);
        height += ui.px(10) + QuestionDrawer(c, *beat.prediction, {prose.x, y, prose.w, prose.h}).draw();
    }
    ui.end_scroll(height);
    if (beside) {
        const float x = place.x + std::round(kQuestion * place.w);
        ui::hairline(ui, {std::round((place.x + left + x - ui.px(2)) / 2), place.y + pad}, place.h - 2 * pad, true);
        const float top = place.y + ui.px(11);
        const Area area =
            ui.begin_scroll("lesson/question", {x, top, place.right() - pad - x, place.bottom() - top - 1});
        ui.end_scroll(QuestionDrawer(c, *beat.prediction, area).draw());
    }
    ui.end_panel();
}

}  // namespace texelscope
