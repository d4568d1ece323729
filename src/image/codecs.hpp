#pragma once
// One function a file format, each in its own file; encode() chooses among them.

#include <string>

#include "image/image.hpp"
#include "image/tone.hpp"

namespace lancer::image {

/// PNG of RGB, tagged sRGB, without a time stamp.
std::string encode_png8(const Image& image, const ToneCurve& curve);
std::string encode_png16(const Image& image, const ToneCurve& curve);

/// P6: a text header, then three bytes a pixel (https://netpbm.sourceforge.net/doc/ppm.html).
std::string encode_ppm(const Image& image, const ToneCurve& curve);

/// P3: the same in decimal text. No line is longer than 70 characters, every row starts a line, no pixel is
/// torn.
std::string encode_ppm_ascii(const Image& image, const ToneCurve& curve);

/// Portable float map: a text header with the scale -1.0 for little-endian, then rows of floats from the
/// bottom up (https://www.pauldebevec.com/Research/HDR/PFM/).
std::string encode_pfm(const Image& image);

/// OpenEXR scan lines: channels R, G, B of 32-bit floats, Rec. 709 primaries, ZIP compression.
std::string encode_exr(const Image& image);

}  // namespace lancer::image
