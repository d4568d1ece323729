#pragma once
// Image -> the bytes of a file. The same image gives the same bytes: nothing of the time or the machine goes
// in.

#include <string>

#include "image/format.hpp"
#include "image/image.hpp"

namespace lancer::image {

/// The bytes of a file in that format. PNG and PPM hold the picture as shown: times `exposure` (positive),
/// clamped, sRGB-encoded, rounded. PFM and EXR hold the linear values themselves, before exposure. The image
/// has at least one pixel. Beside the image it takes little more memory than the bytes returned. Throws
/// std::bad_alloc only.
std::string encode(const Image& image, Format format, double exposure);

}  // namespace lancer::image
