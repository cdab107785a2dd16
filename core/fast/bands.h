// Threads, behind one file.
#pragma once

#include <functional>
#include <initializer_list>

namespace texelscope {

/// One kind of work after the other, by the same threads.
struct Stage {
    int parts;
    std::function<void(int part)> work;
};

/// Does all parts of each stage, in any order, before the next one begins: as many at once as the machine has cores, at
/// most `threads`. A thread that is done takes what others have not begun.
void run_stages(int threads, std::initializer_list<Stage> stages);

}  // namespace texelscope
