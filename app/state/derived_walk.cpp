// The rows of a shape with the places where they meet its sides, each read off the row's own step.
#include "app/lesson/facts.h"
#include "app/state/derived_cache.h"

namespace texelscope {
namespace {

/// A stage's rows, in order; false where there is no more room.
[[nodiscard]] bool add_rows(const Drawing& drawing, const Path& stage, std::vector<WalkedRow>& rows) {
    const auto loop = visit(drawing, stage).unit().loop;
    if (!loop || loop->letter != 'y') return true;
    if (loop->count() + static_cast<Integer>(rows.size()) > kMaxWalkedRows) return false;
    for (Integer y = loop->first; loop->contains(y); y += loop->step) {
        const Path path = stage.child('y', y);
        const Visit row = visit(drawing, path);
        const auto left = value_named(row, "x_l"), right = value_named(row, "x_r");
        if (left && right && !undefined(*left) && !undefined(*right))
            rows.push_back({path, y, approximate(*left), approximate(*right)});
    }
    return true;
}

}  // namespace

const std::vector<WalkedRow>& Derived::walked_rows() const {
    auto& found = cache_->of_drawing.walked;
    const int n = shape();
    if (found && found->first == n) return found->second;
    found.emplace(n, std::vector<WalkedRow>{});
    if (n < 0) return found->second;
    std::vector<WalkedRow>& rows = found->second;
    const Path shape{{{'t', n}}};
    const std::size_t stages = texelscope::visit(drawing(), shape).stages.size();
    for (std::size_t s = 0; s < stages; ++s) {
        if (!add_rows(drawing(), shape.child('s', static_cast<Integer>(s)), rows)) return rows.clear(), rows;
    }
    return rows;
}

}  // namespace texelscope
