// BEAD_EXPECTS(condition): a precondition that only a bug can break. Prints the place and aborts.
#pragma once
#include <cstdio>
#include <cstdlib>

namespace bead {

[[noreturn]] inline void broken_expectation(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "beadwork has a bug: %s:%d expects %s\n", file, line, condition);
    std::abort();
}

}  // namespace bead

#ifdef BEAD_CHECK_EXPECTS
#define BEAD_EXPECTS(condition) \
    ((condition) ? void() : ::bead::broken_expectation(#condition, __FILE__, __LINE__))
#else
#define BEAD_EXPECTS(condition) void()
#endif
