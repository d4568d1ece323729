// For every processor.
#define LANCER_TARGET baseline
#include "tracer/packet/aim.inc"
#include "tracer/packet/exits.inc"
#include "tracer/packet/land.inc"
#include "tracer/packet/light.inc"
#include "tracer/packet/onward.inc"
#include "tracer/packet/paint.inc"
#include "tracer/packet/power.inc"
#include "tracer/packet/search.inc"
