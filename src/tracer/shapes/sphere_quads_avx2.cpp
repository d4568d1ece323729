// For processors with AVX2; compiled with it on.
#define LANCER_TARGET avx2
#include "tracer/shapes/sphere_quads.inc"
