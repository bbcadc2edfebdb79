#include "view3d/shape_shader.h"

namespace raytree::inspector {

std::string see_through_code(Ink line) {
    const auto number = [](std::uint8_t value) { return std::to_string(value / 255.0); };
    return "//VTK::Light::Impl\n"
           "  bool flat_shape = vertexColorVSOutput.a > 0.5;\n"
           "  float firm = vertexColorVSOutput.a * 255.0 / 127.0 - (flat_shape ? 128.0/127.0 : "
           "0.0);\n"
           "  float turned = flat_shape ? 0.0 : 1.0 - abs(normalVCVSOutput.z);\n"
           "  float rim = turned * turned;\n"
           "  gl_FragData[0].a = clamp(firm * opacityUniform * (1.0 + 0.8 * rim) + 0.5 * rim * "
           "rim,\n"
           "                           0.0, 1.0);\n"
           "  gl_FragData[0].rgb = mix(gl_FragData[0].rgb, vec3(" +
           number(line.r) + "," + number(line.g) + "," + number(line.b) + "), 0.75 * rim * rim);\n";
}

// Steeper than the fading itself: what is half seen hides what is behind it all the same.
std::string solid_code() {
    return "//VTK::Light::Impl\n"
           "  bool flat_shape = vertexColorVSOutput.a > 0.5;\n"
           "  float firm = 12.0 * (vertexColorVSOutput.a - 128.0/255.0);\n"
           "  gl_FragData[0].a = flat_shape ? clamp(firm, 0.0, 1.0) : 1.0;\n";
}

}  // namespace raytree::inspector
