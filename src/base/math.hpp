#pragma once
// Elementary functions that give the same bits on every machine and compiler. The C library's differ between
// processors with and without fused multiply-add, and everything here may reach a picture. They are computed
// in double-double arithmetic and rounded once: correctly rounded but for about one argument in 2^40.
// Angles are degrees. Arguments outside a function's domain give NaN, overflow gives infinity, as in <cmath>.

namespace lancer::math {

/// Exact wherever the result is 0, +-1/2 or +-1; never -0.
double sin_deg(double degrees);
double cos_deg(double degrees);
/// Exact wherever the result is 0 or +-1; infinite at odd multiples of 90.
double tan_deg(double degrees);
/// Exact at 0, +-1/2 and +-1.
double asin_deg(double s);
double acos_deg(double c);
/// Exact at 0 and +-1.
double atan_deg(double t);
/// In [-180, 180], -180 only where it is the nearest number; exact at multiples of 45. atan2(0, 0) is 0.
double atan2_deg(double y, double x);
/// The same angle in the other unit.
double radians(double degrees);
double degrees(double radians);

double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double cbrt(double x);
/// As C's pow: exact where the result is, pow(x, 0) = 1, NaN for a negative base and a broken exponent.
double pow(double x, double y);

/// The sRGB transfer curve (IEC 61966-2-1): display value 0..1 to linear light 0..1, and back.
double srgb_to_linear(double value);
double linear_to_srgb(double light);

}  // namespace lancer::math
