#include "tracer/shapes/rim.hpp"

#include "tracer/exact.hpp"
#include "tracer/expansion.hpp"

namespace lancer::tracer {
namespace {

template <class Number>
Triple<Number> triple(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// The side of the line from b to c on which the moved ray passes; 0: the ray runs along the line.
template <class Number>
int side_of_edge(Vec3 b, Vec3 c, Vec3 origin, const Triple<Number>& d) {
  const Triple<Number> o = triple<Number>(origin);
  const int side = dot(d, cross(triple<Number>(b) - o, triple<Number>(c) - o)).sign();
  if (side != 0) return side;
  const Triple<Number> n = cross(d, triple<Number>(c) - triple<Number>(b));
  return sign_beside(n.x, n.y, n.z);
}

template <class Number>
bool is_crossed(const FacetPrimitive& f, Vec3 origin, Vec3 direction) {
  const Triple<Number> d = triple<Number>(direction);
  const int side = side_of_edge(f.a, f.b, origin, d);
  return side != 0 && side_of_edge(f.b, f.c, origin, d) == side && side_of_edge(f.c, f.a, origin, d) == side;
}

}  // namespace

bool is_crossed_beside(const FacetPrimitive& facet, Vec3 origin, Vec3 direction) {
  bool quick = true;
  for (const Vec3 v : {facet.a, facet.b, facet.c, origin, direction}) quick = quick && is_expandable(v);
  return quick ? is_crossed<Expansion>(facet, origin, direction)
               : is_crossed<Exact>(facet, origin, direction);
}

}  // namespace lancer::tracer
