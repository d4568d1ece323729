// For every processor.
#define LANCER_TARGET baseline
#include "tracer/packet/land.inc"
#include "tracer/packet/light.inc"
#include "tracer/packet/power.inc"
#include "tracer/packet/search.inc"
