#include "core/measure/bill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/method/shortcut.h"
#include "core/method/steps.h"

namespace texelscope {
namespace {

constexpr std::array<std::string_view, 3> kOthers{"forward", "sampling-1d", "two-pass"};
constexpr Integer kMostSamples = 600'000;  ///< that the counted shapes' boxes may hold: more would hold up a frame
constexpr std::size_t kMostOfRow = 64;     ///< samples of a row that are counted one by one

[[nodiscard]] bool has_fraction(const Value& value) {
    return !std::holds_alternative<bool>(value) && !std::holds_alternative<Integer>(value);
}

/// A sample that can be gone to again.
struct Place {
    int shape = -1;
    Integer x = 0, y = 0;
};

class Counter {
public:
    Counter(const Scene& scene, const Method& method)
        : drawing_(scene, {&method, NumberFormat::f64, method.variants.back().quirks, {}}), steps_(drawing_) {
        bill_.method = &method;
        bill_.shapes = drawing_.shape_count();
    }

    Bill count() {
        const int step = stride();
        for (int n = 0; n < drawing_.shape_count(); n += step) {
            if (drawing_.refusal(n) == Fate::written) add_shape(n);
            ++bill_.counted;
        }
        if (!largest_) return bill_;
        add_rows_and_samples();
        return bill_;
    }

private:
    /// Every so many shapes are counted.
    [[nodiscard]] int stride() const {
        Integer samples = 0;
        for (int n = 0; n < drawing_.shape_count(); ++n) {
            const Rect box = drawing_.reach(n);
            samples += box.empty() ? 0 : Integer{box.width()} * box.height();
        }
        const auto parts = [](Integer all, Integer most) { return static_cast<int>((all + most - 1) / most); };
        return std::max({1, parts(drawing_.shape_count(), kMostBilled), parts(samples, kMostSamples)});
    }
    void add_shape(int n) {
        bill_.set_up = bill_.set_up + operations_on(visit(drawing_, Path{{{'t', n}}}).tape);
        Integer written = 0, x = 0, y = 0, rows = 0, columns = 0;
        std::optional<Place> first;
        each_sample(drawing_, n, n + 1, {drawing_.scene().framebuffer.rect(), 1}, [&](int, const Sample& s) {
            const auto fate = static_cast<std::size_t>(s.fate);
            if (samples_[fate]++ == 0) met_[fate] = {n, s.x, s.y};
            rows += !first || s.y != y, columns += !first || s.x != x;
            x = s.x, y = s.y;
            if (!first) first = Place{n, s.x, s.y};
            written += s.fate == Fate::written;
            ++bill_.samples;
        });
        // Along a line of samples one of the two stays.
        bill_.rows += std::min(rows, columns);
        bill_.pixels += written;
        if (written > most_written_) most_written_ = written, largest_ = n;
    }

    [[nodiscard]] OperationCount of_unit(const Path& path) { return operations_on(steps_.at(path).tape); }
    /// What the sample at a place needs beyond its row.
    [[nodiscard]] OperationCount of_sample(const Place& place) {
        const auto path = steps_.at_pixel(place.shape, place.x, place.y);
        if (!path || path->parts.size() != 4) return {};
        return of_unit(*path) - of_unit(path->prefix(3));
    }
    /// A written sample's place in the middle of the largest shape.
    [[nodiscard]] Place middle() {
        Place found;
        Integer n = 0;
        each_sample(drawing_, *largest_, *largest_ + 1, {drawing_.scene().framebuffer.rect(), 1},
                    [&](int shape, const Sample& s) {
                        if (s.fate == Fate::written && n++ == most_written_ / 2) found = {shape, s.x, s.y};
                    });
        return found;
    }
    void add_rows_and_samples() {
        for (std::size_t fate = 0; fate < samples_.size(); ++fate) {
            if (samples_[fate] == 0 || fate == static_cast<std::size_t>(Fate::written)) continue;
            bill_.in_pixels = bill_.in_pixels + samples_[fate] * of_sample(met_[fate]);
        }
        const Place typical = middle();
        const auto path = steps_.at_pixel(typical.shape, typical.x, typical.y);
        if (!path || path->parts.size() != 4) return;
        bill_.in_rows = bill_.rows * (of_unit(path->prefix(3)) - of_unit(path->prefix(2)));
        add_written(*path);
    }
    /// Samples written: as many as there are, each as costly as those of one row on the average.
    void add_written(const Path& path) {
        const Path row = path.prefix(3);
        const bool column = row.parts[2].letter == 'x';
        const Rect frame = drawing_.scene().framebuffer.rect();
        const auto line = static_cast<int>(row.parts[2].index);
        const Rect strip = column ? Rect{line, frame.y0, line + 1, frame.y1} : Rect{frame.x0, line, frame.x1, line + 1};
        std::vector<Integer> places;
        each_sample(drawing_, *largest_, *largest_ + 1, {strip, 1}, [&](int, const Sample& s) {
            if (s.fate == Fate::written && places.size() < kMostOfRow) places.push_back(column ? s.y : s.x);
        });
        OperationCount sum;
        for (const Integer at : places) sum = sum + of_unit(row.child(path.parts[3].letter, at));
        const auto count = static_cast<Integer>(places.size());
        if (count == 0) return;
        sum = sum - count * of_unit(row);
        const auto mean = [&](Integer n) { return (n * bill_.pixels + count / 2) / count; };
        bill_.in_pixels =
            bill_.in_pixels + OperationCount{mean(sum.additions), mean(sum.multiplications), mean(sum.divisions)};
    }

    Drawing drawing_;
    Steps steps_;
    Bill bill_;
    static constexpr std::size_t kFates = 32;
    std::array<Integer, kFates> samples_{};  ///< by fate
    std::array<Place, kFates> met_{};        ///< the first of each fate
    std::optional<int> largest_;
    Integer most_written_ = 0;
};

}  // namespace

OperationCount operations_on(const Tape& tape, std::int32_t from, std::int32_t to) {
    std::vector<bool> constant(tape.operations.size());
    OperationCount n;
    for (std::int32_t o = 0; o < to; ++o) {
        const Operation& op = tape.operations[static_cast<std::size_t>(o)];
        const auto fixed = [&](std::int32_t x) { return x < 0 || constant[static_cast<std::size_t>(x)]; };
        const bool leaf = op.op == Op::input || op.op == Op::constant;
        constant[static_cast<std::size_t>(o)] =
            op.op == Op::constant || (!leaf && fixed(op.a) && fixed(op.b) && fixed(op.c));
        if (o < from || leaf || constant[static_cast<std::size_t>(o)] || !has_fraction(op.value)) continue;
        n.additions += op.op == Op::add || op.op == Op::subtract;
        n.multiplications += op.op == Op::multiply;
        n.divisions += op.op == Op::divide;
    }
    return n;
}
OperationCount operations_on(const Tape& tape) {
    return operations_on(tape, 0, static_cast<std::int32_t>(tape.operations.size()));
}

double Bill::set_up_share() const {
    const Integer all = whole().all();
    return all > 0 ? static_cast<double>(set_up.all()) / static_cast<double>(all) : 0;
}

double Bill::scene_pixels() const {
    return counted > 0 ? static_cast<double>(pixels) * static_cast<double>(shapes) / static_cast<double>(counted) : 0;
}

Bill bill_of(const Scene& scene, const Method& method) { return Counter(scene, method).count(); }

std::vector<const Method*> racers() {
    std::vector<const Method*> all;
    for (const Method* method : methods()) {
        const bool other = std::find(kOthers.begin(), kOthers.end(), method->id) != kOthers.end();
        if (!other && shortcut_of(*method) == nullptr) all.push_back(method);
    }
    return all;
}

}  // namespace texelscope
