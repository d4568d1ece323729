// libFuzzer's target for the whole way from bytes to a picture.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/try_script.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lancer::test::try_script(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
