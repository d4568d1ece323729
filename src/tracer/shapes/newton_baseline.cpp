// For every processor.
#define LANCER_TARGET baseline
#include "tracer/shapes/newton.inc"
