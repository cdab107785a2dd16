// TEXELSCOPE_ASSERT(x): the caller broke a documented precondition. On in Debug, sanitizer and test builds.
#pragma once

#include <cstdlib>

#ifdef TEXELSCOPE_ASSERTS
#define TEXELSCOPE_ASSERT(condition) ((condition) ? static_cast<void>(0) : std::abort())
#else
#define TEXELSCOPE_ASSERT(condition) static_cast<void>(0)
#endif
