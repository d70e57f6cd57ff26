#pragma once

/// Functions marked BATTEN_CLONES exist once per vector width in one binary; the loader takes the
/// best the processor offers. Contraction is off, so the copies give the same bits. What they call
/// is to be BATTEN_INLINE, so that it is made for the same width.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BATTEN_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define BATTEN_CLONES
#endif

#ifdef __GNUC__
#define BATTEN_INLINE inline __attribute__((always_inline))
#else
#define BATTEN_INLINE inline
#endif
