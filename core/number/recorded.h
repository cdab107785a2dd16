// Recorded<V>: a V that writes each operation on it to a tape. A method run with it leaves its whole
// calculation behind, with no change to its code and none to its values.
#pragma once

#include <cstdint>
#include <utility>

#include "core/image/wrap.h"
#include "core/number/real.h"
#include "core/trace/tape.h"

namespace texelscope {

/// Where recorded values write. While muted, values pass by without a mark: rounds of a loop that are run only
/// because a later round needs them.
struct TapeWriter {
    Tape tape;
    int muted = 0;
};

template <class V>
class Recorded {
public:
    using Plain = V;

    Recorded() = default;
    template <class W>
    requires std::is_arithmetic_v<W>
    explicit Recorded(W constant) : value_(static_cast<V>(constant)) {}
    explicit Recorded(V value) requires(!std::is_arithmetic_v<V>) : value_(std::move(value)) {}
    /// A whole number becomes a T by construction, as in T(i).
    template <class I>
    requires(std::same_as<I, Integer> && !std::same_as<V, Integer>) explicit Recorded(const Recorded<I>& whole)
        : Recorded(V(whole.value()), whole.writer(), Op::to_real, whole) {}
    Recorded(V value, TapeWriter* writer, std::int32_t operation)
        : value_(std::move(value)), writer_(writer), operation_(operation) {}
    /// The result of `op` on recorded operands; constants among them are put on the tape first.
    template <class A, class... Rest>
    Recorded(V value, TapeWriter* writer, Op op, const A& a, const Rest&... rest)
        : value_(std::move(value)), writer_(writer) {
        if (writer_ == nullptr || writer_->muted > 0) return;
        const std::int32_t operands[] = {a.on_tape(*writer_), rest.on_tape(*writer_)...};
        operation_ =
            writer_->tape.push(op, value_, operands[0], sizeof...(Rest) > 0 ? operands[sizeof...(Rest) > 0] : -1,
                               sizeof...(Rest) > 1 ? operands[sizeof...(Rest)] : -1);
    }

    [[nodiscard]] const V& value() const { return value_; }
    [[nodiscard]] TapeWriter* writer() const { return writer_; }
    [[nodiscard]] const Name& name() const { return name_; }
    [[nodiscard]] std::int32_t operation() const { return operation_; }
    [[nodiscard]] explicit operator bool() const requires std::same_as<V, bool> { return value_; }

    /// The operation that made this value. A constant, or a value carried out of muted rounds, is put there now.
    [[nodiscard]] std::int32_t on_tape(TapeWriter& writer) const {
        if (operation_ >= 0) return operation_;
        const std::int32_t leaf = writer.tape.push(name_.empty() ? Op::constant : Op::input, value_);
        if (!name_.empty()) writer.tape.names.push_back({leaf, name_, name_line_, true});
        return leaf;
    }
    /// The same value under a name that is printed once an unmuted operation needs it.
    [[nodiscard]] Recorded carried(Name name, int line) const {
        Recorded copy(value_, writer_, -1);
        copy.name_ = name;
        copy.name_line_ = line;
        return copy;
    }

private:
    V value_{};
    TapeWriter* writer_ = nullptr;  ///< null for constants
    std::int32_t operation_ = -1;   ///< -1 for constants and muted values
    Name name_;                     ///< of a value carried out of muted rounds
    int name_line_ = 0;
};

template <class X>
struct IsRecorded : std::false_type {};
template <class V>
struct IsRecorded<Recorded<V>> : std::true_type {};

namespace recorded_detail {

template <class A, class B>
[[nodiscard]] TapeWriter* writer_of(const Recorded<A>& a, const Recorded<B>& b) {
    return a.writer() != nullptr ? a.writer() : b.writer();
}
template <class X>
[[nodiscard]] const X& lift(const X& x) requires IsRecorded<X>::value {
    return x;
}
template <class X>
[[nodiscard]] Recorded<Integer> lift(X x) requires std::integral<X> {
    return Recorded<Integer>(static_cast<Integer>(x));
}
[[nodiscard]] inline Recorded<bool> lift(bool x) { return Recorded<bool>(x); }

template <class X>
concept Operand = IsRecorded<X>::value || std::integral<X>;
template <class A, class B>
concept Operands = Operand<A> && Operand<B> &&(IsRecorded<A>::value || IsRecorded<B>::value);

template <class F, class A, class B>
[[nodiscard]] auto apply(Op op, F f, const A& a_, const B& b_) {
    const auto& a = lift(a_);
    const auto& b = lift(b_);
    auto value = f(a.value(), b.value());
    return Recorded<decltype(value)>(std::move(value), writer_of(a, b), op, a, b);
}
template <class F, class V>
[[nodiscard]] auto apply(Op op, F f, const Recorded<V>& a) {
    auto value = f(a.value());
    return Recorded<decltype(value)>(std::move(value), a.writer(), op, a);
}
/// Whole numbers beside a float are taken as that float, as the language does; never through double.
template <class A, class B, class F>
[[nodiscard]] auto arithmetic(const A& a, const B& b, F f) {
    if constexpr (std::same_as<A, Integer> && std::floating_point<B>)
        return f(static_cast<B>(a), b);
    else if constexpr (std::floating_point<A> && std::same_as<B, Integer>)
        return f(a, static_cast<A>(b));
    else
        return f(a, b);
}

}  // namespace recorded_detail

#define TEXELSCOPE_RECORDED_OPERATOR(symbol, op)                                                                   \
    template <class A, class B>                                                                                    \
    requires recorded_detail::Operands<A, B>                                                                       \
    [[nodiscard]] auto operator symbol(const A& a, const B& b) {                                                   \
        return recorded_detail::apply(                                                                             \
            op,                                                                                                    \
            [](const auto& x, const auto& y) {                                                                     \
                return recorded_detail::arithmetic(x, y, [](const auto& s, const auto& t) { return s symbol t; }); \
            },                                                                                                     \
            a, b);                                                                                                 \
    }
TEXELSCOPE_RECORDED_OPERATOR(+, Op::add)
TEXELSCOPE_RECORDED_OPERATOR(-, Op::subtract)
TEXELSCOPE_RECORDED_OPERATOR(*, Op::multiply)
TEXELSCOPE_RECORDED_OPERATOR(/, Op::divide)
TEXELSCOPE_RECORDED_OPERATOR(<, Op::less)
TEXELSCOPE_RECORDED_OPERATOR(<=, Op::less_equal)
TEXELSCOPE_RECORDED_OPERATOR(>, Op::greater)
TEXELSCOPE_RECORDED_OPERATOR(>=, Op::greater_equal)
TEXELSCOPE_RECORDED_OPERATOR(==, Op::equal)
TEXELSCOPE_RECORDED_OPERATOR(!=, Op::not_equal)
TEXELSCOPE_RECORDED_OPERATOR(&&, Op::both)
TEXELSCOPE_RECORDED_OPERATOR(||, Op::either)
TEXELSCOPE_RECORDED_OPERATOR(&, Op::bit_and)
#undef TEXELSCOPE_RECORDED_OPERATOR

template <class V>
[[nodiscard]] Recorded<V> operator-(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::negate, [](const V& x) { return V(-x); }, a);
}
[[nodiscard]] inline Recorded<bool> operator!(const Recorded<bool>& a) {
    return recorded_detail::apply(
        Op::invert, [](bool x) { return !x; }, a);
}
template <class V>
[[nodiscard]] Recorded<Integer> floor(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::floor, [](const V& x) { return floor(x); }, a);
}
template <class V>
[[nodiscard]] Recorded<Integer> trunc(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::trunc, [](const V& x) { return trunc(x); }, a);
}
template <class V>
[[nodiscard]] Recorded<Integer> ceil(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::ceil, [](const V& x) { return ceil(x); }, a);
}
template <class V>
[[nodiscard]] Recorded<Integer> round_even(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::round_even, [](const V& x) { return round_even(x); }, a);
}
template <class V>
[[nodiscard]] Recorded<V> single(const Recorded<V>& a) {
    return recorded_detail::apply(
        Op::single, [](const V& x) { return V(single(x)); }, a);
}
template <class V>
[[nodiscard]] Recorded<V> lesser(const Recorded<V>& a, const Recorded<V>& b) {
    return recorded_detail::apply(
        Op::lesser, [](const V& x, const V& y) { return lesser(x, y); }, a, b);
}
template <class V>
[[nodiscard]] Recorded<V> greater(const Recorded<V>& a, const Recorded<V>& b) {
    return recorded_detail::apply(
        Op::greater_of, [](const V& x, const V& y) { return greater(x, y); }, a, b);
}
template <class V>
[[nodiscard]] Recorded<V> choose(const Recorded<bool>& c, const Recorded<V>& a, const Recorded<V>& b) {
    TapeWriter* writer = c.writer() != nullptr ? c.writer() : recorded_detail::writer_of(a, b);
    return Recorded<V>(c.value() ? a.value() : b.value(), writer, Op::choose, c, a, b);
}
[[nodiscard]] inline Recorded<Integer> euclidean_modulo(const Recorded<Integer>& a, Integer size) {
    return recorded_detail::apply(
        Op::modulo, [](Integer x, Integer y) { return euclidean_modulo(x, y); }, a, size);
}
[[nodiscard]] inline Integer plain(const Recorded<Integer>& i) { return i.value(); }
[[nodiscard]] inline bool plain(const Recorded<bool>& b) { return b.value(); }
template <class V>
[[nodiscard]] double approximate(const Recorded<V>& x) {
    return approximate(x.value());
}

template <class V>
struct NumberTypes<Recorded<V>> {
    using Int = Recorded<Integer>;
    using Truth = Recorded<bool>;
};
template <class V>
struct Input<Recorded<V>> {
    [[nodiscard]] static Recorded<V> from(double x, NumberMode mode) { return Recorded<V>(Input<V>::from(x, mode)); }
};

static_assert(Real<Recorded<double>> && Real<Recorded<float>> && Real<Recorded<Fixed16>> && Real<Recorded<Exact>>);

}  // namespace texelscope
