// A function compiled twice, for any processor and for one with wide registers; which one runs is
// chosen when the program starts. No products are fused, so both give the same bits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define BEAD_WIDE_REGISTERS __attribute__((target_clones("avx2", "default")))
#else
#define BEAD_WIDE_REGISTERS
#endif
