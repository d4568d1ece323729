// For processors with AVX2 and fused multiply-add; compiled with these on.
#define LANCER_TARGET avx2
#include "tracer/packet/aim.inc"
#include "tracer/packet/exits.inc"
#include "tracer/packet/land.inc"
#include "tracer/packet/light.inc"
#include "tracer/packet/onward.inc"
#include "tracer/packet/paint.inc"
#include "tracer/packet/power.inc"
#include "tracer/packet/search.inc"
