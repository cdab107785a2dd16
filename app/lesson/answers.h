// The engine's answers, one function a question; questions.cpp has the table.
#pragma once

#include "app/lesson/questions.h"

namespace texelscope::answers {

// The picture as an array, and who writes what (answers_picture.cpp).
[[nodiscard]] Accepted pixel_of_byte(const Asked& asked);
[[nodiscard]] Accepted byte_of_pixel(const Asked& asked);
[[nodiscard]] Accepted address_of(const Asked& asked);
[[nodiscard]] Accepted doubles(const Asked& asked);
[[nodiscard]] Accepted drawn(const Asked& asked);
[[nodiscard]] Accepted owner(const Asked& asked);
[[nodiscard]] Accepted texel_of(const Asked& asked);

// Steps, values and lines of any method (answers_steps.cpp).
[[nodiscard]] Accepted value(const Asked& asked);
[[nodiscard]] Accepted row_pixels(const Asked& asked);
[[nodiscard]] Accepted guilty_line(const Asked& asked);

// Faces in perspective (answers_perspective.cpp).
[[nodiscard]] Accepted row_of_v(const Asked& asked);
[[nodiscard]] Accepted zero_in_denominator(const Asked& asked);

// Triangles by edge equations (answers_triangle.cpp).
[[nodiscard]] Accepted fate(const Asked& asked);
[[nodiscard]] Accepted box_samples(const Asked& asked);
[[nodiscard]] Accepted drawn_after_exchange(const Asked& asked);
[[nodiscard]] Accepted changed_coefficients(const Asked& asked);

// Convex polygons in sections (answers_polygon.cpp).
[[nodiscard]] Accepted sections(const Asked& asked);
[[nodiscard]] Accepted next_pointer(const Asked& asked);
[[nodiscard]] Accepted ghost(const Asked& asked);

// Walks along the sides, limited numbers, weights (answers_numbers.cpp).
[[nodiscard]] Accepted double_row(const Asked& asked);
[[nodiscard]] Accepted first_flip(const Asked& asked);
[[nodiscard]] Accepted weights_at(const Asked& asked);
// Solids (answers_solids.cpp).
[[nodiscard]] Accepted visible_faces(const Asked& asked);
[[nodiscard]] Accepted cut_corners(const Asked& asked);
[[nodiscard]] Accepted cut_weight(const Asked& asked);
// Which texels a row takes, what forward leaves empty, how wide a buffer is (answers_sampling.cpp).
[[nodiscard]] Accepted indices(const Asked& asked);
[[nodiscard]] Accepted index_beyond(const Asked& asked);
[[nodiscard]] Accepted hole_share(const Asked& asked);
[[nodiscard]] Accepted hole(const Asked& asked);
[[nodiscard]] Accepted buffer_width(const Asked& asked);

// What random triangles cost (answers_race.cpp).
[[nodiscard]] Accepted operations_order(const Asked& asked);
[[nodiscard]] Accepted set_up_share(const Asked& asked);
[[nodiscard]] Accepted frames_1995(const Asked& asked);
// What accuracy costs, and what need not be done (answers_measured.cpp).
[[nodiscard]] Accepted error_place(const Asked& asked);
[[nodiscard]] Accepted needed(const Asked& asked);
[[nodiscard]] Accepted uncertain(const Asked& asked);
// Two methods over one scene (answers_mappers.cpp).
[[nodiscard]] Accepted differs(const Asked& asked);
[[nodiscard]] Accepted cause(const Asked& asked);

}  // namespace texelscope::answers
