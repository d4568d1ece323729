// For every processor.
#define LANCER_TARGET baseline
#include "tracer/shapes/sphere_quads.inc"
