#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfThreading.h>
#include <array>
#include <cstring>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "catch.hpp"
#include "image/encode.hpp"
#include "pictures.hpp"

using namespace lancer::image;

namespace {

class Source : public Imf::IStream {
 public:
  explicit Source(const std::string& bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char data[], int length) override {
    if (static_cast<std::size_t>(length) > bytes_.size() - at_) throw std::runtime_error("short");
    at_ += bytes_.copy(data, static_cast<std::size_t>(length), at_);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

std::vector<float> decode(const std::string& bytes, int width, int height) {
  Source source(bytes);
  Imf::InputFile file(source, 0);
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  Imf::FrameBuffer frame;
  const std::array<const char*, 3> names{"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data() + c), 12,
                                      static_cast<std::size_t>(width) * 12));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0, height - 1);
  return values;
}

}  // namespace

TEST_CASE("exr: every value comes back bit by bit, whatever the exposure", "[exr]") {
  // 41 rows are three blocks of the compression's 16, the last not full.
  const Image image = make_ramp(50, 41);
  CHECK(decode(encode(image, Format::exr, 8), 50, 41) == image.data());
}

TEST_CASE("exr: values that are negative, huge, infinite or no number are kept", "[exr]") {
  const float infinity = std::numeric_limits<float>::infinity();
  const Image image =
      make_image(2, 1, {-1, 3e38F, infinity, std::numeric_limits<float>::quiet_NaN(), 1e-45F, 0.1F});
  const std::vector<float> values = decode(encode(image, Format::exr, 1), 2, 1);
  CHECK(std::memcmp(values.data(), image.data().data(), 6 * sizeof(float)) == 0);
}

TEST_CASE("exr: the header says float, Rec. 709, and nothing of the time", "[exr]") {
  const std::string bytes = encode(make_ramp(5, 3), Format::exr, 1);
  Source source(bytes);
  const Imf::InputFile file(source, 0);
  const Imf::Header& header = file.header();
  CHECK(header.dataWindow() == Imath::Box2i({0, 0}, {4, 2}));
  CHECK(header.displayWindow() == header.dataWindow());
  for (const char* name : {"R", "G", "B"}) {
    REQUIRE(header.channels().findChannel(name) != nullptr);
    CHECK(header.channels().findChannel(name)->type == Imf::FLOAT);
  }
  CHECK(header.typedAttribute<Imf::ChromaticitiesAttribute>("chromaticities").value().red ==
        Imath::V2f(0.64F, 0.33F));
  std::set<std::string> names;
  for (auto a = header.begin(); a != header.end(); ++a) names.insert(a.name());
  CHECK(names == std::set<std::string>{"channels", "chromaticities", "compression", "dataWindow",
                                       "displayWindow", "lineOrder", "pixelAspectRatio", "screenWindowCenter",
                                       "screenWindowWidth"});
}

TEST_CASE("exr: the same picture gives the same bytes, whatever OpenEXR's own threads", "[exr]") {
  const std::string before = encode(make_ramp(90, 70), Format::exr, 1);
  const int threads = Imf::globalThreadCount();
  Imf::setGlobalThreadCount(3);
  const std::string after = encode(make_ramp(90, 70), Format::exr, 1);
  Imf::setGlobalThreadCount(threads);
  CHECK(before == after);
}
