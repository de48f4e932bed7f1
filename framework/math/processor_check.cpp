// Stops a program that was compiled for a newer processor than the one it runs on, with a word
// instead of SIGILL. It runs before any other initialiser and uses no instruction beyond the
// oldest.

#if defined(__x86_64__)

#include <unistd.h>

namespace {

void need(bool present, const char* message, unsigned long length) {
    if (!present) {
        [[maybe_unused]] const auto written = write(STDERR_FILENO, message, length);
        _exit(2);
    }
}

#define NEED(feature)                                                         \
    need(__builtin_cpu_supports(feature),                                     \
         "error: this program was built for a processor with " feature        \
         ", which this one lacks; build it here: lessons/run\n",              \
         sizeof("error: this program was built for a processor with " feature \
                ", which this one lacks; build it here: lessons/run\n") -     \
             1)

[[gnu::constructor(101)]] void check_processor() {
    __builtin_cpu_init();
#ifdef GLINT_NEEDS_SSE4_2
    NEED("sse4.2");
#endif
#ifdef GLINT_NEEDS_AVX2
    NEED("avx2");
#endif
#ifdef GLINT_NEEDS_FMA
    NEED("fma");
#endif
#ifdef GLINT_NEEDS_BMI2
    NEED("bmi2");
#endif
#ifdef GLINT_NEEDS_AVX512F
    NEED("avx512f");
#endif
#ifdef GLINT_NEEDS_AVX512BW
    NEED("avx512bw");
#endif
#ifdef GLINT_NEEDS_AVX512DQ
    NEED("avx512dq");
#endif
#ifdef GLINT_NEEDS_AVX512VL
    NEED("avx512vl");
#endif
#ifdef GLINT_NEEDS_AVX512VBMI2
    NEED("avx512vbmi2");
#endif
}

}  // namespace

#endif
