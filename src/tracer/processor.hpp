#pragma once
// What the processor that we run on can do.

namespace lancer::tracer {

#if defined(LANCER_HAS_AVX2)
inline const bool k_use_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif

}  // namespace lancer::tracer
