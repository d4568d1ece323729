// For every processor.
#define LANCER_TARGET baseline
#include "tracer/tree/walk.inc"
