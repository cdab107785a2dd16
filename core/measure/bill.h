// What a method computes to draw a scene, by stage: the part of a race that is the same on every machine.
#pragma once

#include <vector>

#include "core/method/drawing.h"

namespace texelscope {

/// Operations on numbers with a fraction.
struct OperationCount {
    Integer additions = 0, multiplications = 0, divisions = 0;  ///< subtractions are additions

    [[nodiscard]] Integer all() const { return additions + multiplications + divisions; }
    friend OperationCount operator+(const OperationCount& a, const OperationCount& b) {
        return {a.additions + b.additions, a.multiplications + b.multiplications, a.divisions + b.divisions};
    }
    friend OperationCount operator-(const OperationCount& a, const OperationCount& b) { return a + -1 * b; }
    friend OperationCount operator*(Integer n, const OperationCount& a) {
        return {n * a.additions, n * a.multiplications, n * a.divisions};
    }
    friend bool operator==(const OperationCount&, const OperationCount&) = default;
};

/// Of the operations [from, to) of the tape. What is made of constants alone is computed by nobody.
[[nodiscard]] OperationCount operations_on(const Tape& tape, std::int32_t from, std::int32_t to);
[[nodiscard]] OperationCount operations_on(const Tape& tape);

/// What one method computes for a scene.
///
/// Set-up is counted for every shape on its own. A row, and a sample of each fate, is counted where one is met first,
/// and taken as often as there are such rows and samples: they do the same everywhere. Only `subdivided` divides at
/// some pixels of a row and not at others; of written samples the mean over a row of the largest shape is taken.
struct Bill {
    const Method* method = nullptr;
    Integer shapes = 0;                         ///< of the scene
    Integer counted = 0;                        ///< of these, evenly chosen: what all that follows is about
    Integer rows = 0;                           ///< lines of samples
    Integer samples = 0;                        ///< visited, those rejected too
    Integer pixels = 0;                         ///< written, those written again counted again
    OperationCount set_up, in_rows, in_pixels;  ///< before rows; for rows but for their samples; for samples

    [[nodiscard]] OperationCount whole() const { return set_up + in_rows + in_pixels; }
    /// Share of set-up in all operations [0, 1].
    [[nodiscard]] double set_up_share() const;
    /// Pixels of the whole scene: exact where all shapes were counted.
    [[nodiscard]] double scene_pixels() const;
};
inline constexpr Integer kMostBilled = 512;  ///< shapes of a scene that are counted

/// The corrected method with doubles, whatever the scene is drawn with.
[[nodiscard]] Bill bill_of(const Scene& scene, const Method& method);

/// The methods that draw a triangle with its own texture and nothing else, in the order of their ids: not `forward`,
/// which leaves holes, `two-pass`, which reads the texture twice, and `sampling-1d`, which only scales. Nor `exact` and
/// `fast`: they do not compute the steps that they show, so their bills would be another method's.
[[nodiscard]] std::vector<const Method*> racers();

/// What a Pentium of 100 MHz needed for a textured pixel (S3): 10 cycles of 10 ns [s].
inline constexpr double kPixelSeconds1995 = 100e-9;

}  // namespace texelscope
