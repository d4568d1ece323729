#include "image/encode.hpp"

#include "image/codecs.hpp"
#include "image/tone.hpp"

namespace lancer::image {

std::string encode(const Image& image, Format format, double exposure) {
  switch (format) {
    case Format::png8: return encode_png8(image, ToneCurve(exposure));
    case Format::png16: return encode_png16(image, ToneCurve(exposure));
    case Format::ppm: return encode_ppm(image, ToneCurve(exposure));
    case Format::ppm_ascii: return encode_ppm_ascii(image, ToneCurve(exposure));
    case Format::pfm: return encode_pfm(image);
    case Format::exr: return encode_exr(image);
  }
  return {};
}

}  // namespace lancer::image
