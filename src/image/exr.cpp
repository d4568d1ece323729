// OpenEXR through its library, written to memory by one thread.

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string_view>

#include "image/codecs.hpp"

namespace lancer::image {

namespace {

/// What OpenEXR writes to: a string that can be gone back in, as the table of line offsets needs.
class MemoryStream : public Imf::OStream {
 public:
  explicit MemoryStream(std::string& out) : OStream("memory"), out_(out) {}

  void write(const char data[], int length) override {
    const std::string_view bytes(data, static_cast<std::size_t>(length));
    const std::size_t over = std::min(bytes.size(), out_.size() - at_);
    out_.replace(at_, over, bytes);
    at_ += bytes.size();
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

 private:
  std::string& out_;
  std::size_t at_ = 0;
};

constexpr std::array<const char*, 3> k_channels{"R", "G", "B"};

Imf::Header make_header(const Image& image) {
  Imf::Header header(image.width(), image.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // by default those of Rec. 709
  for (const char* channel : k_channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  return header;
}

/// The image's own memory as OpenEXR sees it.
Imf::FrameBuffer frame_of(const Image& image) {
  constexpr std::size_t pixel_bytes = 3 * sizeof(float);
  const std::size_t row_bytes = pixel_bytes * static_cast<std::size_t>(image.width());
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < k_channels.size(); ++c) {
    // A Slice serves readers too and so is not const; an output file only reads from it.
    auto* base = reinterpret_cast<char*>(const_cast<float*>(image.data().data() + c));
    frame.insert(k_channels[c], Imf::Slice(Imf::FLOAT, base, pixel_bytes, row_bytes));
  }
  return frame;
}

}  // namespace

std::string encode_exr(const Image& image) {
  std::string out;
  MemoryStream stream(out);
  try {
    constexpr int extra_threads = 0;
    Imf::OutputFile file(stream, make_header(image), extra_threads);
    file.setFrameBuffer(frame_of(image));
    file.writePixels(image.height());
  } catch (const std::exception&) {
    // OpenEXR turns what it meets into errors of its own; writing to memory, that is the want of it.
    throw std::bad_alloc();
  }  // the file's destructor has written the table of line offsets
  return out;
}

}  // namespace lancer::image
