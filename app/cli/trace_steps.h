// The steps that `trace` prints: all of a drawing, or the chain that leads to one pixel.
#pragma once

#include <functional>
#include <optional>

#include "core/method/steps.h"

namespace texelscope {

/// A sample's absolute place.
struct Place {
    Integer x = 0, y = 0;
    friend bool operator==(const Place&, const Place&) = default;
};

/// Returns false to stop.
using OnStep = std::function<bool(const Path&)>;

/// Every step at `level`, in drawing order.
void each_step(Steps& steps, Level level, const OnStep& on_step);
/// Only the steps of units that visit `place`, and what leads to them: of each shape that visits it, the stages up to
/// the last visit, without those rounds of their loops that lie elsewhere.
void each_step_at(Steps& steps, Level level, Place place, const OnStep& on_step);

/// The pixel a unit is about: the rounds x and y it is in, or the names x and y that it gives, or nothing.
[[nodiscard]] std::optional<Place> place_of(const Visit& visit);
/// The value of the last expression of the visit's unit with this name.
[[nodiscard]] std::optional<Value> value_of(const Visit& visit, std::string_view name);

}  // namespace texelscope
