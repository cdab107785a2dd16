#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/lesson/answers.h"
#include "core/measure/bill.h"

namespace texelscope::answers {
namespace {

constexpr double kPercentEitherWay = 10;
constexpr double kFramesEitherWay = 0.05;  ///< of the right number

/// Operations for each pixel written, set-up and rows shared out among them.
[[nodiscard]] double per_pixel(const Bill& bill) {
    return bill.pixels > 0 ? static_cast<double>(bill.whole().all()) / static_cast<double>(bill.pixels) : 0;
}
/// The first stage of the step's shape: set-up.
[[nodiscard]] Path set_up_step(const Asked& asked) {
    return asked.shape() < 0 ? Path{} : Path{{{'t', asked.shape()}, {'s', 0}}};
}

}  // namespace

Accepted operations_order(const Asked& asked) {
    struct Entry {
        int digit;
        Bill bill;
    };
    std::vector<Entry> entries;
    for (const std::string& id : asked.call.words)
        entries.push_back({static_cast<int>(entries.size()) + 1, bill_of(asked.drawing.scene(), *find_method(id))});
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return a.bill.whole().all() < b.bill.whole().all(); });
    Accepted a{.step = asked.step.prefix(1), .sentence = "Nothing is drawn here."};
    if (asked.shape() < 0 || entries.front().bill.pixels == 0) return a;
    double digits = 0;
    std::string costs;
    for (const Entry& entry : entries) {
        digits = digits * 10 + entry.digit;
        costs += fmt::format("{}{:.1f}", costs.empty() ? "" : ", ", per_pixel(entry.bill));
    }
    a.number = digits;
    a.sentence = fmt::format("{}: {} operations for each pixel.", digits, costs);
    return a;
}

Accepted set_up_share(const Asked& asked) {
    const Method* method =
        asked.call.words.empty() ? asked.drawing.settings().method : find_method(asked.call.words.front());
    Accepted a{.step = set_up_step(asked), .sentence = "Nothing is computed here."};
    const Bill bill = bill_of(asked.drawing.scene(), *method);
    if (bill.whole().all() == 0) return a;
    a.number = 100 * bill.set_up_share();
    a.tolerance = kPercentEitherWay;
    a.sentence = fmt::format("Set-up takes {} of {} operations: {:.0f} percent.", bill.set_up.all(), bill.whole().all(),
                             *a.number);
    return a;
}

Accepted frames_1995(const Asked& asked) {
    Accepted a{.step = asked.step.prefix(1), .sentence = "No pixel is drawn here."};
    const double pixels = bill_of(asked.drawing.scene(), *asked.drawing.settings().method).scene_pixels();
    if (pixels < 1) return a;
    const double seconds = pixels * kPixelSeconds1995;
    a.number = 1 / seconds;
    a.tolerance = *a.number * kFramesEitherWay;
    a.sentence = fmt::format("{:.0f} pixels at 100 ns take {:.3g} ms: {:.3g} frames a second.", pixels, seconds * 1000,
                             *a.number);
    return a;
}

}  // namespace texelscope::answers
