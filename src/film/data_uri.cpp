#include "film/data_uri.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace vkpt {

std::string pngDataUri(const Bytes& png) {
    using namespace boost::archive::iterators;
    using Base64 = base64_from_binary<transform_width<const char*, 6, 8>>;
    const char* data = reinterpret_cast<const char*>(png.data());
    std::string text(Base64(data), Base64(data + png.size()));
    text.append((3 - png.size() % 3) % 3, '=');
    return "data:image/png;base64," + text;
}

}  // namespace vkpt
