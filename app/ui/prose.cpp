#include "app/ui/prose.h"

#include <algorithm>
#include <cmath>

#include "app/ui/text.h"

namespace texelscope::ui {
namespace {

constexpr std::string_view kMarks = "$*`";

/// A piece that no line break divides from the next unless `space` is set.
struct Piece {
    ProseItem item;
    bool space = false;    ///< a space, and so a place to break, before it
    bool newline = false;  ///< a forced break before it
    float space_width = 0;
};

class Breaker {
public:
    Breaker(const Fonts& fonts, const ProseStyle& style, float width) : fonts_(fonts), style_(style), width_(width) {}

    ProseLayout layout(std::span<const Span> spans) {
        for (const Span& span : spans) add(span);
        for (std::size_t from = 0; from < pieces_.size();) {
            std::size_t to = from + 1;
            while (to < pieces_.size() && !pieces_[to].space && !pieces_[to].newline) ++to;
            place(from, to);
            from = to;
        }
        finish_line();
        return std::move(out_);
    }

private:
    const Font& font_of(Span::Kind kind) const {
        return fonts_.face(kind == Span::Kind::strong ? style_.strong
                           : kind == Span::Kind::code ? style_.code
                                                      : style_.face);
    }

    void add(const Span& span) {
        if (span.kind == Span::Kind::math) {
            if (const auto e = parse_math(span.text)) {
                Piece p;
                p.item.math = set_math(span.role == Role::text ? *e : coloured(*e, span.role),
                                       {&fonts_, style_.math, false, false});
                p.item.width = p.item.math.width;
                push(std::move(p), span);
                return;
            }
        }
        const Font& font = font_of(span.kind);
        for (std::size_t at = 0; at < span.text.size();) {
            if (span.text[at] == ' ' || span.text[at] == '\n') {
                pending_space_ = true;
                pending_newline_ |= span.text[at] == '\n';
                space_width_ = text_width(font, " ");
                ++at;
                continue;
            }
            const std::size_t end = std::min(span.text.find_first_of(" \n", at), span.text.size());
            Piece p;
            p.item.font = &font;
            p.item.text = span.text.substr(at, end - at);
            p.item.width = text_width(font, p.item.text);
            push(std::move(p), span);
            at = end;
        }
    }

    void push(Piece p, const Span& span) {
        p.item.role = span.role;
        p.item.link = span.link;
        p.space = pending_space_;
        p.newline = pending_newline_;
        p.space_width = space_width_;
        pending_space_ = pending_newline_ = false;
        pieces_.push_back(std::move(p));
    }

    void place(std::size_t from, std::size_t to) {
        float width = 0;
        for (std::size_t i = from; i < to; ++i) width += pieces_[i].item.width;
        const float gap = line_.empty() ? 0 : pieces_[from].space_width;
        if (pieces_[from].newline || (!line_.empty() && x_ + gap + width > width_)) {
            finish_line();
        } else {
            x_ += gap;
        }
        for (std::size_t i = from; i < to; ++i) place_piece(std::move(pieces_[i].item));
    }

    void place_piece(ProseItem item) {
        while (item.font != nullptr && x_ + item.width > width_ && item.text.size() > 1) {
            const std::size_t n = line_break(*item.font, item.text, width_ - x_);
            if (n == 0 || n >= item.text.size()) break;
            ProseItem head = item;
            head.text = item.text.substr(0, n);
            head.width = text_width(*head.font, head.text);
            if (!line_.empty() && x_ + head.width > width_) {
                finish_line();
                continue;
            }
            put_item(std::move(head));
            finish_line();
            item.text.erase(0, n);
            item.width = text_width(*item.font, item.text);
        }
        put_item(std::move(item));
    }

    void put_item(ProseItem item) {
        item.at.x = x_;
        x_ += item.width;
        line_.push_back(std::move(item));
    }

    void finish_line() {
        if (line_.empty()) return;
        const Font& face = fonts_.face(style_.face);
        const float pitch = std::round(face.em * style_.lead);
        float up = (pitch + face.cap) / 2, down = pitch - up;
        for (const ProseItem& item : line_) {
            if (item.font != nullptr) continue;
            up = std::max(up, item.math.ascent + 2);
            down = std::max(down, item.math.descent + 1);
        }
        const float baseline = std::round(out_.height + up);
        if (out_.lines == 0) out_.baseline = baseline;
        for (ProseItem& item : line_) {
            item.at.y = baseline;
            out_.items.push_back(std::move(item));
        }
        out_.height = std::round(baseline + down);
        out_.width = std::max(out_.width, x_);
        ++out_.lines;
        x_ = 0;
        line_.clear();
    }

    const Fonts& fonts_;
    const ProseStyle& style_;
    float width_;
    std::vector<Piece> pieces_;
    bool pending_space_ = false, pending_newline_ = false;
    float space_width_ = 0;
    std::vector<ProseItem> line_;
    float x_ = 0;
    ProseLayout out_;
};

}  // namespace

std::vector<Span> spans_of(std::string_view text, Role role) {
    std::vector<Span> out;
    std::string plain;
    const auto flush = [&] {
        if (!plain.empty()) out.push_back({Span::Kind::text, plain, role, 0});
        plain.clear();
    };
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '\\' && at + 1 < text.size() && kMarks.find(text[at + 1]) != std::string_view::npos) {
            plain += text[at + 1];
            at += 2;
            continue;
        }
        const std::string_view mark = c == '*' ? "**" : text.substr(at, 1);
        const bool opens = kMarks.find(c) != std::string_view::npos && text.substr(at, mark.size()) == mark;
        const std::size_t end = opens ? text.find(mark, at + mark.size()) : std::string_view::npos;
        if (end == std::string_view::npos || end == at + mark.size()) {
            plain += c;
            ++at;
            continue;
        }
        flush();
        const Span::Kind kind = c == '$' ? Span::Kind::math : c == '*' ? Span::Kind::strong : Span::Kind::code;
        out.push_back({kind, std::string(text.substr(at + mark.size(), end - at - mark.size())), role, 0});
        at = end + mark.size();
    }
    flush();
    return out;
}

ProseLayout layout_prose(const Fonts& fonts, std::span<const Span> spans, float width, const ProseStyle& style) {
    return Breaker(fonts, style, width).layout(spans);
}

}  // namespace texelscope::ui
