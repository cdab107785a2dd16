// What watches a method run. A trace changes no value and no decision; it may only narrow the range of a loop.
// NoTrace hands everything back and costs nothing; WindowTrace keeps loops over pixels inside a rectangle;
// Listener (recording.h) writes one unit to a tape. Never call a trace twice in one argument list or operand
// list: compilers differ in the order.
#pragma once

#include <concepts>

#include "core/base/rect.h"
#include "core/number/real.h"
#include "core/trace/fate.h"
#include "core/trace/name.h"

namespace texelscope {

/// The rounds first, first + step, … up to but without last; none where first is already past it.
class Range {
public:
    constexpr Range(Integer first, Integer last, Integer step) : first_(first), last_(last), step_(step) {
        const Integer distance = (last - first) * (step > 0 ? 1 : -1), stride = step > 0 ? step : -step;
        last_ = distance <= 0 ? first : first + (distance + stride - 1) / stride * step;
    }
    struct Iterator {
        Integer at, step;
        constexpr Integer operator*() const { return at; }
        constexpr Iterator& operator++() { return at += step, *this; }
        constexpr bool operator!=(const Iterator& other) const { return at != other.at; }
    };
    [[nodiscard]] constexpr Iterator begin() const { return {first_, step_}; }
    [[nodiscard]] constexpr Iterator end() const { return {last_, step_}; }

private:
    Integer first_, last_, step_;
};

/// Upward by ones, which compilers know best.
class UpRange {
public:
    constexpr UpRange(Integer first, Integer last) : first_(first), last_(last < first ? first : last) {}
    struct Iterator {
        Integer at;
        constexpr Integer operator*() const { return at; }
        constexpr Iterator& operator++() { return ++at, *this; }
        constexpr bool operator!=(const Iterator& other) const { return at != other.at; }
    };
    [[nodiscard]] constexpr Iterator begin() const { return {first_}; }
    [[nodiscard]] constexpr Iterator end() const { return {last_}; }

private:
    Integer first_, last_;
};

/// From first toward last, without it, by ones either way.
class TowardRange {
public:
    constexpr TowardRange(Integer first, Integer last) : first_(first), last_(last) {}
    [[nodiscard]] constexpr Range::Iterator begin() const { return {first_, first_ <= last_ ? 1 : -1}; }
    [[nodiscard]] constexpr Range::Iterator end() const { return {last_, 1}; }

private:
    Integer first_, last_;
};

/// Nobody watches.
struct NoTrace {
    /// Whether a run may be asked for one unit alone, so that none may count on what units before it have left behind.
    static constexpr bool kVisits = false;
    template <class V>
    constexpr V operator()(Name, V value, int = 0) const {
        return value;
    }
    constexpr void stage(const char*) const {}
    constexpr Fate fate(Fate fate) const { return fate; }
    constexpr UpRange each(char, Integer first, Integer last) const { return {first, last}; }
    /// As each(), for rounds that may put samples anywhere: a window leaves it whole.
    constexpr UpRange stray(char, Integer first, Integer last) const { return {first, last}; }
    constexpr UpRange walk(char, Integer first, Integer last) const { return {first, last}; }
    constexpr UpRange fill(char, Integer first, Integer last) const { return {first, last}; }
    constexpr TowardRange toward(char, Integer first, Integer last) const { return {first, last}; }
    /// Whether anybody asks for round `index` of a walk, or only for what it hands on.
    constexpr bool wanted(char, Integer) const { return true; }
    constexpr auto quiet(auto&& stage) const { return stage(); }
};

/// A view of the picture: only samples in `rect` are of interest, and of these one in `stride` each way.
struct Window {
    Rect rect;
    int stride = 1;  ///< samples x with (x - rect.x0) % stride == 0, y alike
    friend bool operator==(const Window&, const Window&) = default;
};

/// Loops over y and x keep inside the window; the values that they compute there are the same.
struct WindowTrace : NoTrace {
    Window window;

    explicit constexpr WindowTrace(const Window& window_) : window(window_) {}
    constexpr Range each(char letter, Integer first, Integer last) const {
        if (letter != 'x' && letter != 'y') return {first, last, 1};
        const Integer low = letter == 'x' ? window.rect.x0 : window.rect.y0;
        const Integer high = letter == 'x' ? window.rect.x1 : window.rect.y1;
        const Integer start =
            first <= low ? low : low + (first - low + window.stride - 1) / window.stride * window.stride;
        return {start, last < high ? last : high, window.stride};
    }
    /// The rounds before the window are needed, those after it are not.
    constexpr Range walk(char letter, Integer first, Integer last) const {
        const Integer high = letter == 'x' ? window.rect.x1 : letter == 'y' ? window.rect.y1 : last;
        return {first, last < high ? last : high, 1};
    }
    /// What comes later needs all rounds, but over pixels only those in the window.
    constexpr Range fill(char letter, Integer first, Integer last) const { return each(letter, first, last); }
    constexpr bool wanted(char letter, Integer index) const {
        if (letter != 'x' && letter != 'y') return true;
        const Integer low = letter == 'x' ? window.rect.x0 : window.rect.y0;
        const Integer high = letter == 'x' ? window.rect.x1 : window.rect.y1;
        return index >= low && index < high && (index - low) % window.stride == 0;
    }
    constexpr Range toward(char letter, Integer first, Integer last) const {
        if (first <= last) return each(letter, first, last);
        if (letter != 'x' && letter != 'y') return {first, last, -1};
        const Integer low = letter == 'x' ? window.rect.x0 : window.rect.y0;
        const Integer high = letter == 'x' ? window.rect.x1 : window.rect.y1;
        const Integer top = first < high ? first : high - 1;
        const Integer start = top < low ? top : low + (top - low) / window.stride * window.stride;
        return {start, last > low - 1 ? last : low - 1, -window.stride};
    }
};

template <class Trace>
concept Traceable = requires(const Trace trace, double value, IntegerOf<double> i) {
    {trace.stage("name")};
    { trace.fate(Fate::written) } -> std::same_as<Fate>;
};

}  // namespace texelscope
