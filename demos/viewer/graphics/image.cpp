#include "viewer/graphics/image.h"

// Declares what Dear ImGui's library or Debian's libstb defines.
#include <stb/stb_image_write.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "record/output_file.h"

namespace polhode::demos {

namespace {

constexpr int kChannels = 3;

void append(void* text, void* data, int size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  OutputFile output(file);
  std::string bytes;
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, kChannels, image.rgb.data(),
                             kChannels * image.width) == 0) {
    throw std::runtime_error(file.string() + ": the picture cannot be encoded");
  }
  output.write(bytes);
  output.commit();
}

}  // namespace polhode::demos
