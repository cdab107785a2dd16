// Which of Highway's targets are compiled: one for each generation of machines. Before <hwy/foreach_target.h>.
#pragma once

// SSSE3 and AVX-512 with its newest extensions would be compiled anew and win nothing over SSE4 and AVX-512.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
