// For processors with AVX2 and fused multiply-add; compiled with these on.
#define LANCER_TARGET avx2
#include "tracer/shapes/newton.inc"
